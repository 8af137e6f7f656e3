/* Fills memory that it shares with its children. Expect: MLE */
#define _GNU_SOURCE
#include <sys/mman.h>
#include <unistd.h>

int main(void) {
    size_t size = 1 << 30;
    volatile char *filler = mmap(0, size, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    fork();
    for (size_t at = 0; at < size; at += 4096) filler[at] = 1;
    sleep(5);
}
