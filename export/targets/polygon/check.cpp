// Checker: the tokens of the output are those of the answer, in either letter case.
// One token answers one scenario. testlib's own tokens end at a blank, a tab or a line end only;
// these end at a vertical tab or a form feed, too, as they do for the kit's own judge.

#include <string>

#include "testlib.h"

bool at_space(InStream& in) {
    static const std::string WHITE = " \t\n\r\v\f";
    return !in.eof() && WHITE.find(char(in.curChar())) != std::string::npos;
}

// The next token in small letters; "" at the end.
std::string next_token(InStream& in) {
    while (at_space(in)) in.skipChar();
    std::string token;
    while (!in.eof() && !at_space(in)) token += char(in.nextChar());
    return lowerCase(token);
}

int main(int argc, char* argv[]) {
    setName("the same tokens, in either letter case");
    registerTestlibCmd(argc, argv);
    for (int scenario = 1;; scenario++) {
        const std::string expected = next_token(ans), found = next_token(ouf);
        if (expected.empty() && found.empty()) quitf(_ok, "%d answers", scenario - 1);
        if (expected != found)
            quitf(_wa, "scenario %d: expected %s, found %s", scenario,
                  expected.empty() ? "the end" : compress(expected).c_str(),
                  found.empty() ? "the end" : compress(found).c_str());
    }
}
