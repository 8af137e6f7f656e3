/* Fills memory with page tables, a little in each of many processes. Expect: MLE RTE */
#include <stdio.h>
#include <sys/mman.h>
#include <unistd.h>

int main(void) {
    long size = 3900L << 20, sum = 0;
    for (int i = 0; i < 100; i++)
        if (fork() == 0) {
            volatile char *room = mmap(0, size, PROT_READ, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
            if (room == MAP_FAILED) return 1;
            for (long at = 0; at < size; at += 2 << 20) sum += room[at];
            sleep(5);
            return (int)sum;
        }
    sleep(2);
    puts("YES");
}
