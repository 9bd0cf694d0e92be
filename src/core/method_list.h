/* One word per method: src/core/method_NAME.c defines thud_method_NAME. The order is that of `thud methods`. */
THUD_METHOD(exact)
THUD_METHOD(central_difference)
THUD_METHOD(newmark)
THUD_METHOD(newmark_linear)
THUD_METHOD(hht)
THUD_METHOD(generalized_alpha)
THUD_METHOD(lagged)
