// The header is C++ as well: a program that includes it, compiles, links and runs.
#include "../hooke.h"

int main()
{
    return hooke_size_of(HOOKE_PRECISION_F64, 1, 0, 0) > 0 ? 0 : 1;
}
