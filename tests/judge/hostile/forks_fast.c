/* Forks as fast as it can. By itself it ends after ten seconds. Expect: RTE TLE */
#include <time.h>
#include <unistd.h>

int main(void) {
    time_t ends = time(0) + 10;
    while (time(0) < ends) fork();
}
