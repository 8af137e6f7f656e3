/* Instantiates templates without end. Expect: CE */
template <int N>
int deeper() {
    return deeper<N + 1>();
}

int main() { return deeper<0>(); }
