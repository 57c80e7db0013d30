namespace { int x = 3; inline int f(long a) { int y = a; return y; } }
