/* Tries to leave single pages in pipes, each of which keeps 2 MiB of memory. Expect: AC */
#define _GNU_SOURCE
#include <fcntl.h>
#include <stdio.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/uio.h>
#include <unistd.h>

int main(void) {
    size_t huge = 2 << 20;
    for (int i = 0, ends[2]; i < 25 && pipe(ends) == 0; i++)
        for (int part = 0; part < 16; part++) {
            char *room = mmap(0, 2 * huge, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
            char *filler = room + huge - (size_t)room % huge;
            madvise(filler, huge, MADV_HUGEPAGE);
            memset(filler, 1, huge);
            struct iovec page = {filler, 4096};
            if (vmsplice(ends[1], &page, 1, SPLICE_F_NONBLOCK) > 0) return 1;
            munmap(room, 2 * huge);
        }
    for (int c; (c = getchar()) != EOF;) putchar(c);
}
