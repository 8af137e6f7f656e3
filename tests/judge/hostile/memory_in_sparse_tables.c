/* Fills memory with the page tables of single pages that lie far apart. Expect: MLE */
#include <stdio.h>
#include <sys/mman.h>
#include <unistd.h>

int main(void) {
    pid_t other = fork();
    long apart = 2L << 30, sum = 0;
    char *place = (char *)(1L << 40);
    for (long i = 0; i < 60000; i++) {
        volatile char *page = mmap(place + i * apart, 4096, PROT_READ,
                                   MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE | MAP_FIXED, -1, 0);
        if (page == MAP_FAILED) break;
        sum += *page;
    }
    sleep(1);
    if (other) puts(sum ? "NO" : "YES");
}
