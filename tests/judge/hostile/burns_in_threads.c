/* Burns time in four threads while the main one waits. Expect: TLE */
#include <pthread.h>

static void *burn(void *unused) {
    for (volatile int i = 0;; i = 1) {}
    return unused;
}

int main(void) {
    pthread_t thread;
    for (int i = 0; i < 4; i++) pthread_create(&thread, 0, burn, 0);
    pthread_join(thread, 0);
}
