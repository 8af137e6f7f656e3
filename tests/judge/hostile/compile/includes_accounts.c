/* Makes the assembler read the account files. Expect: CE */
__asm__(".incbin \"/etc/passwd\"");
__asm__(".incbin \"/etc/shadow\"");

int main(void) { return 0; }
