/* A contact law by callbacks: its table calls functions that find the caller's behind thud_law_setup.law. */
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "door/door.h"

static const struct thud_contact_law *call_of(const struct thud_law_setup *setup)
{
    return &((const struct thud_door_law *)(const void *)setup->law)->call; /* the table is its first member */
}

static struct thud_branch branch(const struct thud_law_setup *setup, const struct thud_law_memory *memory,
                                 enum thud_phase phase, bool past_ultimate)
{
    struct thud_force f = {.p = 1, .r = 1};
    const struct thud_contact_law *call = call_of(setup);
    (past_ultimate ? call->force_past : call->force)(call->context, setup->mass_kg, memory->own,
                                                     phase == THUD_RESTITUTION, &f);
    return (struct thud_branch){
        .f0_n = f.f0_n, .k_npm = f.k_npm, .c_nspm = f.c_nspm, .K = f.K, .p = f.p, .D = f.D, .r = f.r};
}

static double ultimate(const struct thud_law_setup *setup, const struct thud_law_memory *memory, enum thud_phase phase)
{
    return call_of(setup)->ultimate(call_of(setup)->context, setup->mass_kg, memory->own, phase == THUD_RESTITUTION);
}

static bool keeps_residual(const struct thud_law_setup *setup)
{
    return call_of(setup)->keeps_residual;
}

static double energy(const struct thud_law_setup *setup, const struct thud_law_memory *memory, double d_m)
{
    return call_of(setup)->energy(call_of(setup)->context, setup->mass_kg, memory->own, d_m);
}

static void onset(const struct thud_law_setup *setup, double v_mps, struct thud_law_memory *memory)
{
    call_of(setup)->onset(call_of(setup)->context, setup->mass_kg, v_mps, memory->own);
}

static void reversal(const struct thud_law_setup *setup, enum thud_phase phase, double d_m,
                     struct thud_law_memory *memory)
{
    call_of(setup)->reversal(call_of(setup)->context, setup->mass_kg, phase == THUD_RESTITUTION, d_m, memory->own);
}

static bool is_word(const char *name)
{
    return name && *name && strlen(name) < THUD_NAME_MAX &&
           strspn(name, "abcdefghijklmnopqrstuvwxyz0123456789-") == strlen(name);
}

static enum thud_status refuse(const struct thud *scene, int interface, const struct thud_contact_law *law,
                               struct thud_error *err)
{
    const int n = scene->session.scene.nstructures - 1;
    if (interface < 1 || interface > n) {
        thud_error_set(err, THUD_INPUT, "there is no interface %d", interface);
        thud_error_allow(err, "1 to %d", n);
    } else if (!is_word(law->name) || thud_law_find(law->name)) {
        thud_error_set(err, THUD_INPUT, "the law's name is none of its own");
        thud_error_allow(err, "small letters, digits and hyphens, and no law of `thud laws`");
    } else if (!law->force || !law->energy) {
        thud_error_set(err, THUD_INPUT, "the law has no force, or no energy");
    } else if (!law->ultimate != !law->force_past) {
        thud_error_set(err, THUD_INPUT, "ultimate and force_past go together: one of them is missing");
    } else {
        return THUD_OK;
    }
    thud_error_key(err, "contact.law");
    return THUD_INPUT;
}

enum thud_status thud_set_law(struct thud *scene, int interface_from_1, const struct thud_contact_law *law,
                              struct thud_error *err)
{
    struct thud_contact_law call;
    enum thud_status status = THUD_NEED(err, scene, law);
    if (status == THUD_OK)
        status = thud_door_read(law, offsetof(struct thud_contact_law, ultimate), &call, sizeof call,
                                "thud_contact_law", err);
    if (status == THUD_OK)
        status = refuse(scene, interface_from_1, &call, err);
    struct thud_door_law *own = status == THUD_OK ? calloc(1, sizeof *own) : NULL;
    if (status != THUD_OK)
        return status;
    if (!own)
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    own->call = call;
    snprintf(own->name, sizeof own->name, "%s", call.name);
    own->table = (struct thud_law){.name = own->name,
                                   .title = own->name,
                                   .reference = "",
                                   .summary = "",
                                   .flags = (call.pulls ? (unsigned)THUD_LAW_PULLS : 0) |
                                            (call.reversal ? (unsigned)THUD_LAW_REVERSES : 0),
                                   .branch = branch,
                                   .elastic_energy = energy,
                                   .onset = call.onset ? onset : NULL,
                                   .reversal = call.reversal ? reversal : NULL,
                                   .ultimate = call.ultimate ? ultimate : NULL,
                                   .keeps_residual = keeps_residual};
    struct thud_interface *at = &scene->session.scene.interface[interface_from_1 - 1];
    thud_law_choice_init(&at->contact, &own->table);
    free(scene->law[interface_from_1 - 1]); /* nothing else points to the law before */
    scene->law[interface_from_1 - 1] = own;
    return THUD_OK;
}
