/* Recurses for ever. Expect: RTE MLE */
static int dive(volatile int depth) { return dive(depth + 1) + depth; }

int main(void) { return dive(0); }
