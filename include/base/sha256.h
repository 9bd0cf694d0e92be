/* SHA-256 (FIPS 180-4), which identifies a file. */
#pragma once

#include <stddef.h>

enum { THUD_SHA256_TEXT = 65 };
/* Writes the SHA-256 digest of `size` bytes in hexadecimal. */
void thud_sha256(const void *bytes, size_t size, char text[THUD_SHA256_TEXT]);
