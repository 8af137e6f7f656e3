/* Includes itself without end. Expect: CE */
#include __FILE__
