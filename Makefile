# thud: earthquake pounding of neighbouring buildings.  `make help` lists what can be made.
VARIANT  ?= release
CC       ?= cc
PREFIX   ?= /usr/local
DESTDIR  ?=
B        := build/$(VARIANT)

WARN     := -Wall -Wextra -Wpedantic -Wshadow -Wconversion $(if $(CI),-Werror)
release  := -O3 -DNDEBUG
debug    := -O0 -g3
asan     := -O1 -g -fno-omit-frame-pointer -fsanitize=address,undefined -fno-sanitize-recover=all
coverage := -O0 -g --coverage
LIBS     := yaml-0.1 lapacke lapack ncursesw
CPPFLAGS += -Iinclude -Isrc -D_POSIX_C_SOURCE=200809L $(shell pkg-config --cflags $(LIBS) 2>/dev/null)
CFLAGS   += -std=c17 -ffp-contract=off -fno-math-errno $(WARN) $($(VARIANT)) -MMD -MP -pthread
LDLIBS   += -lcsv $(shell pkg-config --libs $(LIBS) 2>/dev/null) -lm

LAYERS   := base core study io plot app cli tui
SRC      := $(wildcard $(LAYERS:%=src/%/*.c))
OBJ      := $(SRC:%.c=$(B)/%.o)
LIB      := $(B)/libthud.a
UNIT     := $(patsubst tests/unit/%.c,$(B)/unit/%,$(filter-out tests/unit/main.c,$(wildcard tests/unit/*.c)))

.PHONY: all test demo help clean deps asan valgrind lint coverage fuzz bench
all: thud

thud: $(B)/thud
	cp $< $@
$(B)/thud: $(B)/src/main.o $(LIB)
	$(CC) $(CFLAGS) $(LDFLAGS) -o $@ $^ $(LDLIBS)
$(LIB): $(OBJ)
	rm -f $@ && $(AR) rcs $@ $^
$(B)/%.o: %.c
	@mkdir -p $(@D)
	$(CC) $(CPPFLAGS) $(CFLAGS) -c -o $@ $<
$(B)/unit/%: $(B)/tests/unit/%.o $(B)/tests/unit/main.o $(LIB)
	@mkdir -p $(@D)
	$(CC) $(CFLAGS) $(LDFLAGS) -o $@ $^ $(shell pkg-config --libs check) $(LDLIBS)

deps:
	@tests/tools/install-deps.sh build
test:
	@tests/tools/install-deps.sh test
	@$(MAKE) --no-print-directory thud units
	@tests/tools/run.sh $(B)
units: $(UNIT)
.SECONDARY:
clean:
	rm -rf build thud
-include $(shell find build -name '*.d' 2>/dev/null)
