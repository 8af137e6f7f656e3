/* Answers right if it can fill shared memory and drop it without freeing it. Expect: RTE */
#include <fcntl.h>
#include <stdio.h>
#include <sys/mman.h>

static int keeps(int flags, int file) {
    size_t size = 800 << 20, part = 16 << 20;
    char *filler = mmap(0, size, PROT_READ | PROT_WRITE, flags, file, 0);
    if (filler == MAP_FAILED) return 0;
    for (size_t at = 0; at < size; at += part) {
        for (size_t byte = at; byte < at + part; byte += 4096) filler[byte] = 1;
        madvise(filler + at, part, MADV_DONTNEED);
    }
    puts("YES");
    return 1;
}

int main(void) {
    return !keeps(MAP_SHARED | MAP_ANONYMOUS, -1) && !keeps(MAP_SHARED, open("/dev/zero", O_RDWR));
}
