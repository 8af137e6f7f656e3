/* Executes an unreadable copy, which loses its counter; burns time in children. Expect: TLE RTE */
#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

static void burn(void) {
    while (clock() < 4 * CLOCKS_PER_SEC / 1000) continue;
    _exit(0);
}

int main(int count, char **words) {
    if (count == 1) {
        static char block[1 << 20];
        int self = open("/proc/self/exe", O_RDONLY), copy = open("/tmp/copy", O_CREAT | O_WRONLY, 0700);
        ssize_t size = read(self, block, sizeof block);
        if (write(copy, block, size) != size || fchmod(copy, 0111) || close(copy)) return 1;
        execl("/tmp/copy", words[0], "again", (char *)0);
        return 1;
    }
    signal(SIGCHLD, SIG_IGN);
    for (int i = 0; i < 1000; i++) {
        int over[2];
        char byte;
        if (pipe(over)) return 1;
        pid_t child = fork();
        if (child < 0) return 1;
        if (child == 0) burn();
        close(over[1]);
        if (read(over[0], &byte, 1)) return 1;
        close(over[0]);
    }
    for (int c; (c = getchar()) != EOF;) putchar(c);
}
