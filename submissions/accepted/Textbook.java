// The textbook method: one Minkowski sum per obstacle, and a test whether it holds the origin.
//
// The robot P moves by d. What it covers on the way is its sweep, and the sweep is a
// Minkowski sum itself: P + s, with s the segment from (0, 0) to d. A point of the sweep
// equals a point of the obstacle Q iff some difference of the two is the origin:
//
//     sweep meets Q  <=>  (0, 0) lies in the sum of the sweep and the reflected obstacle -Q.
//
// All sets are closed, so the sum's boundary counts. Exact: 64-bit integers only.
// O(k * m + N) for k obstacles of N vertices in all, since the sweep is walked once for
// each of them. Source: de Berg et al., Computational Geometry (3rd ed.), 13.3.

import java.io.IOException;
import java.io.InputStream;
import java.util.Arrays;

public class Textbook {
    /** A convex polygon, counter-clockwise, starting at its lowest, then leftmost vertex. */
    record Polygon(long[] x, long[] y) {
        int size() {
            return x.length;
        }

        /** Make a polygon of the given vertices, starting at the lowest one. O(n). */
        static Polygon of(long[] x, long[] y) {
            int n = x.length;
            int lowest = 0;
            for (int i = 1; i < n; i++) {
                if (y[i] < y[lowest] || (y[i] == y[lowest] && x[i] < x[lowest])) lowest = i;
            }
            return new Polygon(rotated(x, lowest), rotated(y, lowest));
        }

        private static long[] rotated(long[] values, int first) {
            long[] result = Arrays.copyOfRange(values, first, first + values.length);
            System.arraycopy(values, 0, result, values.length - first, first);
            return result;
        }

        /**
         * Return {p + q : p in this, q in that}, merging the edges of both by direction.
         *
         * <p>A segment is a polygon of two vertices; if its ends coincide, it is a point, and
         * that works as well. O(size() + that.size()).
         */
        Polygon plus(Polygon that) {
            int n = size();
            int m = that.size();
            long[] sumX = new long[n + m];
            long[] sumY = new long[n + m];
            int length = 0;
            int i = 0;
            int j = 0;
            while (i < n || j < m) {
                int p = i % n;
                int pNext = (i + 1) % n;
                int q = j % m;
                int qNext = (j + 1) % m;
                sumX[length] = x[p] + that.x[q];
                sumY[length] = y[p] + that.y[q];
                length++;
                long turn;
                if (i == n) {
                    turn = -1;
                } else if (j == m) {
                    turn = +1;
                } else {
                    turn =
                            cross(
                                    x[pNext] - x[p], y[pNext] - y[p],
                                    that.x[qNext] - that.x[q], that.y[qNext] - that.y[q]);
                }
                if (turn >= 0) i++; // this polygon's edge comes first, or
                if (turn <= 0) j++; // that one's does, or parallel edges become one
            }
            return new Polygon(Arrays.copyOf(sumX, length), Arrays.copyOf(sumY, length));
        }

        /** Is the origin inside the polygon or on its boundary? O(n). */
        boolean containsOrigin() {
            int previous = size() - 1;
            for (int i = 0; i < size(); i++) {
                if (cross(x[previous], y[previous], x[i], y[i]) < 0) return false;
                previous = i;
            }
            return true;
        }
    }

    /** Twice the signed area of (origin, a, b): positive iff b is to the left of a. */
    static long cross(long ax, long ay, long bx, long by) {
        return ax * by - ay * bx;
    }

    /** Integers from a stream, without the cost of java.util.Scanner. */
    static class Input {
        private final InputStream stream = System.in;
        private final byte[] buffer = new byte[1 << 16];
        private int length = 0;
        private int position = 0;

        private int next() throws IOException {
            if (position == length) {
                length = stream.read(buffer);
                position = 0;
                if (length <= 0) return -1;
            }
            return buffer[position++];
        }

        int integer() throws IOException {
            int c = next();
            while (c != '-' && (c < '0' || c > '9')) c = next();
            boolean negative = c == '-';
            if (negative) c = next();
            int value = 0;
            for (; '0' <= c && c <= '9'; c = next()) value = 10 * value + (c - '0');
            return negative ? -value : value;
        }

        /** Read a polygon of n vertices, each multiplied by `sign`: -1 reflects it. */
        Polygon polygon(int n, int sign) throws IOException {
            long[] x = new long[n];
            long[] y = new long[n];
            for (int i = 0; i < n; i++) {
                x[i] = (long) sign * integer();
                y[i] = (long) sign * integer();
            }
            return Polygon.of(x, y);
        }
    }

    public static void main(String[] args) throws IOException {
        Input input = new Input();
        StringBuilder answers = new StringBuilder();
        for (int t = input.integer(); t > 0; t--) {
            int m = input.integer();
            int k = input.integer();
            long dx = input.integer();
            long dy = input.integer();
            Polygon robot = input.polygon(m, 1);
            Polygon move = Polygon.of(new long[] {0, dx}, new long[] {0, dy});
            Polygon sweep = robot.plus(move);

            boolean free = true;
            for (; k > 0; k--) {
                Polygon reflected = input.polygon(input.integer(), -1); // read in any case
                free = free && !sweep.plus(reflected).containsOrigin();
            }
            answers.append(free ? "YES\n" : "NO\n");
        }
        System.out.print(answers);
    }
}
