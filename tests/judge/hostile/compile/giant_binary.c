/* Compiles to a binary of a gigabyte. Expect: CE */
char giant[1 << 30] = {1};

int main(void) { return giant[0]; }
