/* What tests are written with: a failed expectation is told, and counted. */

#ifndef CHECK_H
#define CHECK_H

#include <stdio.h>

static int failures;
static int expectations;

#define EXPECT(condition)                                                              \
    do {                                                                               \
        expectations++;                                                                \
        if (!(condition)) {                                                            \
            failures++;                                                                \
            printf("%s:%d: %s does not hold\n", __FILE__, __LINE__, #condition);       \
        }                                                                              \
    } while (0)

#define EXPECT_CODE(call, expected)                                                    \
    do {                                                                               \
        hooke_code code_ = (call);                                                     \
        expectations++;                                                                \
        if (code_ != (expected)) {                                                     \
            failures++;                                                                \
            printf("%s:%d: %s: %s, not %s\n", __FILE__, __LINE__, #call,               \
                   hooke_message(code_), hooke_message(expected));                     \
        }                                                                              \
    } while (0)

#define EXPECT_OK(call) EXPECT_CODE(call, HOOKE_CODE_OK)

static int conclude(const char *name)
{
    printf("%s: %d expectations, %d failed\n", name, expectations, failures);
    return failures == 0 ? 0 : 1;
}

#endif
