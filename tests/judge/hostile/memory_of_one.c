/* Fills memory. Expect: MLE */
#include <stdlib.h>

int main(void) {
    for (int i = 0; i < 40; i++) {
        volatile char *filler = malloc(100 << 20);
        for (int at = 0; at < 100 << 20; at += 4096) filler[at] = 1;
    }
}
