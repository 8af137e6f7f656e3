/* Fills sockets that nobody reads, in many processes. Expect: MLE */
#include <fcntl.h>
#include <stdio.h>
#include <sys/socket.h>
#include <unistd.h>

static char block[4096];

static void fill(void) {
    int ends[2];
    while (socketpair(AF_UNIX, SOCK_STREAM, 0, ends) == 0)
        for (int i = 0; i < 2; i++) {
            fcntl(ends[i], F_SETFL, O_NONBLOCK);
            while (write(ends[i], block, sizeof block) > 0) continue;
        }
}

int main(void) {
    int full[2];
    char byte;
    if (pipe(full)) return 1;
    for (int i = 0; i < 12; i++)
        if (fork() == 0) {
            fill();
            if (write(full[1], "x", 1) == 1) sleep(5);
            return 0;
        }
    for (int i = 0; i < 12; i++)
        if (read(full[0], &byte, 1) != 1) return 1;
    usleep(200000);
    puts("YES");
}
