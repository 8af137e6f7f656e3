/* Overwrites all memory after a fork, so that nothing is shared any more. Expect: MLE */
#include <stdlib.h>
#include <unistd.h>

int main(void) {
    size_t size = 400 << 20;
    volatile char *filler = malloc(size);
    for (size_t at = 0; at < size; at += 4096) filler[at] = 1;
    fork();
    for (size_t at = 0; at < size; at += 4096) filler[at] = 2;
    sleep(5);
}
