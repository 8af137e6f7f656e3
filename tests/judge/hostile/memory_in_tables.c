/* Fills memory with nothing but page tables. Expect: MLE */
#include <stdio.h>
#include <sys/mman.h>
#include <unistd.h>

int main(void) {
    long gib = 1L << 30, sum = 0;
    for (int i = 0; i < 400; i++) {
        volatile char *room = mmap(0, gib, PROT_READ, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
        if (room == MAP_FAILED) return 1;
        for (long at = 0; at < gib; at += 2 << 20) sum += room[at];
    }
    usleep(100000);
    puts(sum ? "NO" : "YES");
}
