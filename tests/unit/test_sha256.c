/* SHA-256 against the examples of FIPS 180-4 and of NIST's test vectors, over lengths that need one and two last blocks. */
#include <check.h>
#include <string.h>

#include "base/sha256.h"

static void expect(const char *bytes, size_t size, const char *digest)
{
    char text[THUD_SHA256_TEXT];
    thud_sha256(bytes, size, text);
    ck_assert_str_eq(text, digest);
}

START_TEST(examples)
{
    static char million[1000000];
    const char *two = "abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"; /* 56 bytes: two last blocks */
    memset(million, 'a', sizeof million);
    expect("", 0, "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
    expect("abc", 3, "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    expect(two, strlen(two), "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
    expect(million, sizeof million, "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}
END_TEST

Suite *thud_suite(void);
Suite *thud_suite(void)
{
    Suite *suite = suite_create("sha256");
    TCase *tests = tcase_create("sha256");
    tcase_add_test(tests, examples);
    suite_add_tcase(suite, tests);
    return suite;
}
