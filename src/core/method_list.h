/* One word per method: src/core/method_NAME.c defines thud_method_NAME. The order is that of `thud methods`. */
THUD_METHOD(exact)
