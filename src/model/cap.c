/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "model/cap.h"

#include <inttypes.h>
#include <stdio.h>

const cap_record cap_records[CAP_COUNT] = {
    [CAP_FAR] = {"far", "steps refused because a particle would have gone too far"},
    [CAP_JOLT] = {"jolt", "steps refused because they were too long for a force that came to act in them"},
    [CAP_HELD] = {"held",
                  "flexible cells held back in a step: no particle moves by more than 0.4 radii within its cell"},
    [CAP_UNSOLVED] = {"unsolved", "flexible cells whose step was taken before its equations were solved"},
    [CAP_CLAMPED] = {"clamped", "particles left nearer to the substratum than the clamp of force dlvo by a relaxation"},
    [CAP_LIFTED] = {"lifted", "new particles that a division put into the substratum, lifted onto it"},
};

void cap_add(uint64_t *to, const uint64_t *from) {
    for (int i = 0; i < CAP_COUNT; i++)
        to[i] += from[i];
}

void cap_describe(const uint64_t *now, const uint64_t *from, size_t size, char *text) {
    size_t used = 0;
    snprintf(text, size, "none");
    for (int i = 0; i < CAP_COUNT; i++) {
        uint64_t hits = now[i] - (from ? from[i] : 0);
        if (hits == 0 || used >= size)
            continue;
        used +=
            (size_t)snprintf(text + used, size - used, "%s%s %" PRIu64, used ? ", " : "", cap_records[i].name, hits);
    }
}
