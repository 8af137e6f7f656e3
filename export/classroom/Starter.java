// Collision Course. Reads everything; the answer is still to be found.

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.StreamTokenizer;
import java.util.ArrayList;
import java.util.List;

public class Solution {
    /** A convex polygon, counter-clockwise. */
    record Polygon(long[] x, long[] y) {}

    private static final StreamTokenizer INPUT =
            new StreamTokenizer(new BufferedReader(new InputStreamReader(System.in)));

    /** Can the robot make the whole move without touching any obstacle? */
    static boolean isFree(Polygon robot, long dx, long dy, List<Polygon> obstacles) {
        return true;
    }

    static int read() throws IOException {
        INPUT.nextToken();
        return (int) INPUT.nval; // exact: a double holds every number of 32 bits
    }

    static Polygon readPolygon(int vertices) throws IOException {
        Polygon polygon = new Polygon(new long[vertices], new long[vertices]);
        for (int i = 0; i < vertices; i++) {
            polygon.x[i] = read();
            polygon.y[i] = read();
        }
        return polygon;
    }

    public static void main(String[] arguments) throws IOException {
        int scenarios = read();
        StringBuilder answers = new StringBuilder();
        while (scenarios-- > 0) {
            int m = read();
            int k = read();
            long dx = read();
            long dy = read();
            Polygon robot = readPolygon(m);
            List<Polygon> obstacles = new ArrayList<>();
            for (int i = 0; i < k; i++) {
                obstacles.add(readPolygon(read()));
            }
            answers.append(isFree(robot, dx, dy, obstacles) ? "YES\n" : "NO\n");
        }
        System.out.print(answers);
    }
}
