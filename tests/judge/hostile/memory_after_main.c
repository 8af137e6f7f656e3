/* Ends its first thread, which shows the memory in /proc; another fills memory. Expect: MLE */
#include <pthread.h>
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
    puts("YES");
    fflush(stdout);
    _exit(0);
    return nothing;
}

int main(void) {
    pthread_t thread;
    pthread_create(&thread, 0, fill, 0);
    syscall(SYS_exit, 0);
}
