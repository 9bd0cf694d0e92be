# thud: earthquake pounding of neighbouring buildings.  `make help` lists what can be made.
VARIANT  ?= release
CC       ?= cc
PREFIX   ?= /usr/local
FUZZ_SECONDS ?= 30
B        := build/$(VARIANT)
VERSION  := $(or $(shell sed -n 's/.*THUD_VERSION "\(.*\)".*/\1/p' include/base/version.h 2>/dev/null),0.0.0)

# Flags.  CFLAGS, CPPFLAGS and LDFLAGS stay the user's; they come last.  gcc's analyzer sees leaks where a block is kept in a list; the address
# sanitizer and the failing-memory tests look for real ones.
release  := -O3 -fstack-protector-strong $(if $(findstring _FORTIFY_SOURCE,$(CPPFLAGS) $(CFLAGS)),,-U_FORTIFY_SOURCE -D_FORTIFY_SOURCE=2)
debug    := -O0 -g3
asan     := -O1 -g -fno-omit-frame-pointer -fsanitize=address,undefined -fno-sanitize-recover=all
tsan     := -O1 -g -fno-omit-frame-pointer -fsanitize=thread
coverage := -O1 -g -fno-early-inlining --coverage
valgrind := -O1 -g
analyze  := -O1 -fanalyzer -Wno-analyzer-malloc-leak -fdiagnostics-plain-output -Werror
fuzz     := -O1 -g -fno-omit-frame-pointer -fsanitize=fuzzer-no-link,address,undefined -fno-sanitize-recover=all
WARN     := -Wall -Wextra -Wpedantic -Wshadow -Wconversion $(if $(CI),-Werror)
PKG      := yaml-0.1 ncursesw zlib
PKG_I    := $(shell pkg-config --cflags-only-I $(PKG) 2>/dev/null)
PKG_L    := $(shell pkg-config --libs $(PKG) 2>/dev/null)
LAPACK   := $(or $(shell pkg-config --libs lapacke lapack 2>/dev/null),-llapacke)
COMPILE  := $(CC) -Iinclude -Isrc -D_XOPEN_SOURCE=700 $(PKG_I) -std=c17 -pthread -fPIC -fvisibility=hidden -ffp-contract=off -fno-math-errno \
            $(WARN) $($(VARIANT)) $(CPPFLAGS) $(CFLAGS)
HARDENED := $(if $(filter Darwin,$(shell uname -s)),,-pie -Wl,-z,relro,-z,now)
LINK     := $(CC) -pthread $($(VARIANT)) $(if $(filter release,$(VARIANT)),$(HARDENED)) $(CFLAGS) $(LDFLAGS)
LDLIBS   += -lcsv $(PKG_L) $(LAPACK) -lm

# One short line for each file made; V=1 shows the commands themselves.
say       = $(if $(V),,@printf '  %-5s %s\n' '$(1)' '$(2)';)

# Three archives: libthud-core.a computes and touches nothing outside itself, libthud-io.a reads and writes files, libthud-program.a is the program
# around them.  What is installed is libthud, static and shared: of all of these what include/thud.h needs, and no other name than those in it.
objects   = $(patsubst %.c,$(B)/%.o,$(sort $(wildcard $(1))))
room      = src/$(1)/*.c src/$(1)/*/*.c # of a layer: its own files and those of its rooms
CORE     := $(call objects,$(foreach layer,base ground core study,$(call room,$(layer))))
IO       := $(call objects,$(call room,io))
PROGRAM  := $(call objects,$(foreach layer,plot app lab cli tui door,$(call room,$(layer))))
DOOR     := $(call objects,src/door/*.c)
SONAME   := libthud.so.$(firstword $(subst ., ,$(VERSION)))
DOORLIBS  = $(filter-out -lncurses% -ltinfo%,$(LDLIBS))
OBJCOPY  ?= objcopy
PARALLEL  = $(if $(filter -j%,$(MAKEFLAGS)),,-j$(or $(shell nproc 2>/dev/null),2))
UNIT     := $(patsubst tests/unit/%.c,$(B)/unit/%,$(wildcard tests/unit/test_*.c))
HELPERS  := $(call objects,$(filter-out tests/unit/test_%,$(wildcard tests/unit/*.c)))
FAULT    := $(patsubst tests/fault/%.c,$(B)/fault/%,$(wildcard tests/fault/test_*.c))
WRAPPED  := malloc calloc realloc free strdup strndup open mkstemp close read write fsync rename mkdir stat fstat fopen fread fwrite
comma    := ,
HAVE_CVODE = $(shell printf '\043include <cvode/cvode.h>\n' | $(CC) -x c -fsyntax-only - 2>/dev/null && echo yes)
PEERS     = $(B)/peer-exact $(B)/peer-export $(B)/peer-minimal $(if $(HAVE_CVODE),$(B)/peer-cvode)
SUNDIALS := $(patsubst %,-lsundials_%,cvode nvecserial sunmatrixdense sunlinsoldense sunnonlinsolfixedpoint)
FUZZERS  := $(patsubst tests/fuzz/%.c,$(B)/fuzz/%,$(wildcard tests/fuzz/fuzz_*.c))
LIBS     := $(B)/libthud-program.a $(B)/libthud-io.a $(B)/libthud-core.a
THUD     := $(if $(filter release,$(VARIANT)),thud,$(B)/thud)

# What the environment calls by these names is not what the scripts are to get.
unexport THUD

.PHONY: all help deps demo pictures test units debug asan tsan valgrind coverage lint mutants objects fuzz fuzzers soak bench bench-suite bench-peers install uninstall dist deb clean FORCE
all: $(THUD) $(B)/libthud.a $(B)/libthud.so $(B)/thud.pc ## build ./thud (VARIANT=debug, asan, coverage build into build/VARIANT)

help: ## this list
	@sed -n 's/^\([a-z-]*\):.*## \(.*\)/  make \1\t\2/p' Makefile | expand -t 18
	@echo '  variables         VARIANT=$(VARIANT) CC=$(CC) PREFIX=$(PREFIX) DESTDIR= CI=1 (warnings are errors) V=1 (show commands) CFLAGS= FUZZ_SECONDS=$(FUZZ_SECONDS)'

# A file that changes when its text does, so that what depends on it is made again.
keep = @mkdir -p $(@D) && printf '%s\n' '$(1)' | cmp -s - $@ || printf '%s\n' '$(1)' >$@
$(B)/flags: FORCE
	$(call keep,$(COMPILE) $(LDLIBS))
$(B)/files: FORCE
	$(call keep,$(CORE) $(IO) $(PROGRAM) $(HELPERS))
$(B)/commit: FORCE
	$(call keep,$(or $(shell git describe --always --dirty --exclude '*' 2>/dev/null),unknown))
$(B)/thud.pc: FORCE
	$(call keep,prefix=$${pcfiledir}/../..' 'libdir=$${prefix}/lib' 'Name: thud' 'Description: earthquake pounding of neighbouring buildings' 'Version: $(VERSION)' \
	    'Cflags: -I$${prefix}/include' 'Libs: -L$${prefix}/lib -lthud' 'Libs.private: $(DOORLIBS) -pthread)
$(B)/headers: $(B)/flags
	@tests/tools/need.sh $(CC) && touch $@

thud: build/release/thud
	@rm -f $@ && cp $< $@ # one that runs keeps its old file
$(B)/thud: $(B)/src/main.o $(LIBS) | $(B)/presets $(B)/records
	$(call say,LINK,$@)$(LINK) -o $@ $^ $(LDLIBS)
$(B)/presets $(B)/records:
	@mkdir -p $(B) && ln -sfn ../../$(@F) $@
$(B)/libthud-core.a: $(CORE)
$(B)/libthud-io.a: $(IO)
$(B)/libthud-program.a: $(PROGRAM)
$(B)/libtests.a: $(HELPERS)
# one object, in which only what thud.h declares can be seen from outside
$(B)/libthud.a: $(DOOR) $(LIBS)
	$(call say,AR,$@)$(CC) -r -nostdlib -o $(B)/libthud.o $^ && $(OBJCOPY) --localize-hidden $(B)/libthud.o && rm -f $@ && $(AR) rcs $@ $(B)/libthud.o
$(B)/libthud.so: $(DOOR) $(LIBS) | $(B)/presets $(B)/records
	$(call say,LINK,$@)$(filter-out -pie,$(LINK)) -shared -Wl,-soname,$(SONAME) -o $@.$(VERSION) $^ $(DOORLIBS)
	@ln -sf libthud.so.$(VERSION) $(B)/$(SONAME) && ln -sf $(SONAME) $@
$(B)/lib%.a: $(B)/files
	@rm -f $@ && $(AR) rcs $@ $(filter %.o,$^)
$(B)/%.o: %.c $(B)/flags | $(B)/headers
	@mkdir -p $(@D)
	$(call say,CC,$<)$(COMPILE) $(OWN) $(CFLAGS) -MMD -MP -c -o $@ $<
# to optimise what asks and draws takes as long as all else, and makes no answer quicker; nor do tests gain by it
$(filter-out %/version.o,$(PROGRAM)): OWN = $(if $(filter release,$(VARIANT)),-O2)
$(call objects,tests/unit/test_*.c): OWN = $(if $(filter release,$(VARIANT)),-O0 -U_FORTIFY_SOURCE)
$(B)/src/io/file/paths.o: OWN = -DTHUD_DATADIR='"$(PREFIX)/share/thud"'
$(B)/src/%/version.o: OWN = -DTHUD_COMMIT='"$(shell cat $(B)/commit)"' -DTHUD_VARIANT='"$(VARIANT)"'
$(call objects,src/*/version.c): $(B)/commit
# branches of the laws are counted as they are written
$(B)/src/core/laws/law_%.o: OWN = $(if $(filter coverage,$(VARIANT)),-O0)
# gcc's analyzer loses sight of calloc's zeros behind three indices
$(B)/src/study/sweep/sensitivity.o: OWN = $(if $(filter analyze,$(VARIANT)),-Wno-analyzer-use-of-uninitialized-value)
$(B)/unit/%: $(B)/tests/unit/%.o $(B)/libtests.a $(LIBS)
	@mkdir -p $(@D)
	$(call say,LINK,$@)$(LINK) -o $@ $^ $(shell pkg-config --libs check) $(LDLIBS)
$(B)/fault/%: $(B)/tests/fault/%.o $(B)/tests/fault/fault.o $(B)/libtests.a $(LIBS)
	@mkdir -p $(@D)
	$(call say,LINK,$@)$(LINK) $(WRAPPED:%=-Wl$(comma)--wrap=%) -o $@ $^ $(shell pkg-config --libs check) $(LDLIBS)
$(B)/soak $(B)/cross $(B)/pairs $(B)/agree $(B)/simplest: $(B)/%: $(B)/tests/soak/%.o $(B)/libtests.a $(LIBS)
	$(call say,LINK,$@)$(LINK) -o $@ $^ $(shell pkg-config --libs check) $(LDLIBS)
$(B)/fuzz/%: $(B)/tests/fuzz/%.o $(LIBS)
	@mkdir -p $(@D)
	$(call say,LINK,$@)$(LINK) -fsanitize=fuzzer -o $@ $^ $(LDLIBS)
$(B)/bench-%: $(B)/tests/bench/%.o $(B)/tests/bench/scene.o $(LIBS) | $(B)/presets $(B)/records
	$(call say,LINK,$@)$(LINK) -o $@ $^ $(LDLIBS)
$(B)/peer-%: $(B)/tests/bench/peers/%.o $(B)/tests/bench/scene.o $(LIBS) | $(B)/presets $(B)/records
	$(call say,LINK,$@)$(LINK) -o $@ $^ $(if $(filter %-cvode,$@),$(SUNDIALS)) $(LDLIBS)
.SECONDARY:
.DELETE_ON_ERROR:

deps: ## install what building needs (says what; sudo only when needed)
	@tests/tools/install-deps.sh build
demo: deps ## install what is missing, build, run two towers on a real earthquake and a surrogate, write the figures into ./demo
	@$(MAKE) --no-print-directory $(PARALLEL) VARIANT=release all
	@./thud run towers-kaikoura --replace -o demo && ./thud run towers --replace --quiet -o demo/surrogate >/dev/null && \
	    echo "The histories and figures are in $(CURDIR)/demo: Kaikoura 2016 as recorded; in demo/surrogate: the surrogate for Kobe 1995"

test: ## install what the tests need, build, run every test
	@tests/tools/install-deps.sh test
	@$(MAKE) --no-print-directory $(PARALLEL) all units
	@THUD="$$PWD/$(THUD)" MAKEFLAGS= tests/tools/run.sh $(B)
# the programs that measure and the long-lived ones are built too, so that a change of the core cannot leave them behind
units: $(UNIT) $(FAULT) $(B)/bench-time $(B)/peer-minimal $(B)/soak $(B)/cross $(B)/pairs $(B)/agree $(B)/simplest
	@:
debug: ## build/debug/thud: no optimisation, asserts on
	@$(MAKE) --no-print-directory VARIANT=debug all
asan: ## every test under the address and undefined-behaviour sanitizers
	@CK_FORK=no $(MAKE) --no-print-directory VARIANT=asan test
tsan: ## sweeps and screens under the thread sanitizer
	@TEST_ONLY='sweep|study|bench|live|tui|terminal' CK_FORK=no $(MAKE) --no-print-directory VARIANT=tsan test
valgrind: ## the unit tests and the command line's under valgrind's memcheck
	@tests/tools/install-deps.sh test valgrind
	@$(MAKE) --no-print-directory VARIANT=valgrind units all
	@tests/tools/valgrind.sh build/valgrind
coverage: ## lines and branches that the tests pass through, by layer and file
	@find build/coverage -name '*.gcda' -delete 2>/dev/null; CK_TIMEOUT_MULTIPLIER=8 TEST_SECONDS=3000 $(MAKE) --no-print-directory VARIANT=coverage test; tests=$$?; \
	    tests/tools/coverage.sh build/coverage && exit $$tests
lint: ## rules of the house and static analysis with the tools installed (ONLY='format tidy': these, see lint.sh)
	@FLAGS='$(wordlist 2,99,$(COMPILE))' tests/tools/lint.sh $(MAKE) $(ONLY)
mutants: ## takes one protection of the core out at a time: the tests must notice (two minutes on an idle machine; ONLY=word: fewer)
	@tests/tools/install-deps.sh test
	@tests/tools/mutants.sh '$(ONLY)'
objects: $(CORE) $(IO) $(PROGRAM) $(B)/src/main.o
fuzz: ## fuzz each reader for FUZZ_SECONDS from the corpus in tests/fuzz/corpus (needs clang)
	@$(MAKE) --no-print-directory VARIANT=fuzz CC=clang fuzzers
	@tests/tools/fuzz.sh build/fuzz $(FUZZ_SECONDS)
fuzzers: $(FUZZERS)
soak: all ## memory over thousands of runs and edits, studies killed at their writes, every call failing in turn (20 min)
	@$(MAKE) --no-print-directory VARIANT=$(VARIANT) $(B)/soak $(B)/cross $(B)/pairs $(B)/agree $(B)/simplest
	@tests/tools/soak.sh $(B)
bench: all ## measured speeds against their targets, in one table; charts of every method into build/bench (minutes)
	@$(MAKE) --no-print-directory $(B)/bench-time $(B)/bench-memory $(B)/peer-minimal
	@sh tests/bench/targets.sh $(B) build/bench
bench-suite: all ## a study of 59,040 runs: time, processor time, memory, and the same bytes on one thread (minutes)
	@$(MAKE) --no-print-directory $(B)/bench-memory
	@sh tests/bench/suite.sh $(B)
bench-peers: all ## the towers by other integrators (CVODE, SciPy, OpenSeesPy, where installed), for measuring only
	@$(MAKE) --no-print-directory $(PEERS)
	@sh tests/bench/peers/peers.sh $(B) build/bench

pictures: all ## the README's pictures (.github/pictures): towers, acceleration against gap, terminal (needs python3)
	@for p in story impact; do python3 tests/tools/pictures.py $$p ./$(THUD) .github/pictures/$$p.svg || exit 1; done
	@./$(THUD) towers --play .github/pictures/terminal.play >/dev/null

install: all ## program, library, presets, records, manual pages, completions under DESTDIR PREFIX
	@THUD=./$(THUD) BUILD=$(B) tests/tools/install.sh install '$(DESTDIR)$(PREFIX)'
uninstall: ## remove what install put there
	@THUD=./$(THUD) tests/tools/install.sh uninstall '$(DESTDIR)$(PREFIX)'
dist: ## build/thud-VERSION.tar.gz of what is committed
	@mkdir -p build && git archive --format=tar --prefix=thud-$(VERSION)/ HEAD | gzip -n9 >build/thud-$(VERSION).tar.gz
	@echo build/thud-$(VERSION).tar.gz
deb: all ## a Debian package in build/
	@tests/tools/deb.sh $(VERSION) build
clean: ## remove everything made
	rm -rf build thud demo

-include $(shell find $(B) -name '*.d' 2>/dev/null)
