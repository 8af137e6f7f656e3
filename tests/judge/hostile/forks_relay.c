/* Forks and ends, for ever: no process lives long. By itself it ends soon. Expect: TLE RTE WA */
#include <time.h>
#include <unistd.h>

int main(void) {
    time_t ends = time(0) + 10;
    while (fork() == 0 && time(0) < ends) {}
}
