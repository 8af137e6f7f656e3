/* Shares its memory with a child by vfork, as is usual to start a program. Expect: AC */
#define _DEFAULT_SOURCE
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

int main(void) {
    size_t size = 300 << 20;
    volatile char *filler = malloc(size);
    for (size_t at = 0; at < size; at += 4096) filler[at] = 1;
    if (vfork() == 0) {
        usleep(300000);
        _exit(0);
    }
    for (int c; (c = getchar()) != EOF;) putchar(c);
}
