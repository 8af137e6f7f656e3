/* Executes itself again and again. Expect: TLE */
#include <unistd.h>

int main(int count, char **arguments) { return count ? execv("/proc/self/exe", arguments) : 0; }
