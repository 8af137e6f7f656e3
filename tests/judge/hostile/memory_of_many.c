/* Fills memory, a little in each of many processes. Expect: MLE RTE */
#include <stdlib.h>
#include <unistd.h>

int main(void) {
    for (int i = 0; i < 40; i++)
        if (fork() == 0) {
            volatile char *filler = malloc(50 << 20);
            for (int at = 0; at < 50 << 20; at += 4096) filler[at] = 1;
            sleep(5);
            return 0;
        }
    sleep(5);
}
