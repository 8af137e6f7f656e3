/* Becomes itself again and again, so that no process is old. Expect: TLE */
#include <unistd.h>

int main(int count, char **arguments) { return count ? execv("/proc/self/exe", arguments) : 0; }
