/* Fills memory in a child that is reaped automatically, so no peak is reported. Expect: MLE */
#include <pthread.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/syscall.h>
#include <unistd.h>

static void *fill(void *nothing) {
    for (int i = 0; i < 14; i++) {
        memset(malloc(64 << 20), 1, 64 << 20);
        usleep(40000);
    }
    _exit(0);
    return nothing;
}

int main(void) {
    int over[2];
    char byte;
    signal(SIGCHLD, SIG_IGN);
    if (pipe(over)) return 1;
    if (fork() == 0) {
        pthread_t thread;
        pthread_create(&thread, 0, fill, 0);
        syscall(SYS_exit, 0);
    }
    close(over[1]);
    if (read(over[0], &byte, 1)) return 1;
    puts("YES");
}
