/* Starts threads until that is refused, then answers right. Expect: AC */
#include <pthread.h>
#include <stdio.h>
#include <unistd.h>

static void *wait_long(void *unused) {
    pause();
    return unused;
}

int main(void) {
    pthread_attr_t small;
    pthread_attr_init(&small);
    pthread_attr_setstacksize(&small, 1 << 16);
    pthread_t thread;
    for (int i = 0; i < 5000 && pthread_create(&thread, &small, wait_long, 0) == 0; i++) {}
    for (int c; (c = getchar()) != EOF;) putchar(c);
}
