/* Doubles the number of template instances at every depth. Expect: CE */
template <int Depth, long Path>
struct Tree {
    static const long size = Tree<Depth - 1, 2 * Path>::size + Tree<Depth - 1, 2 * Path + 1>::size;
};
template <long Path>
struct Tree<0, Path> {
    static const long size = 1;
};

int main() { return Tree<40, 1>::size > 0; }
