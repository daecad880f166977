#include "command/outputs.h"
#include "base/alloc.h"
#include <math.h>
#include <stdlib.h>
struct outputs {
    int x;
};
outputs *outputs_create(interp *in) {
    (void)in;
    return alloc_zeroed(1, sizeof(outputs));
}
void outputs_free(outputs *o) {
    free(o);
}
int outputs_begin(outputs *o, diag *d) {
    (void)o;
    (void)d;
    return 0;
}
int outputs_step(outputs *o, bool last, diag *d) {
    (void)o;
    (void)d;
    (void)last;
    return 0;
}
void outputs_end(outputs *o) {
    (void)o;
}
void outputs_clear(outputs *o) {
    (void)o;
}
void outputs_save(const outputs *o, archive *a) {
    (void)o;
    (void)a;
}
int outputs_load(outputs *o, const archive *a, diag *d) {
    (void)o;
    (void)d;
    (void)a;
    return 0;
}
bool outputs_due(args_cycles_value every, uint64_t step, double before, double now) {
    if (!every.is_time)
        return every.cycles && step % every.cycles == 0;
    return floor(now / every.time + 1e-9) > floor(before / every.time + 1e-9);
}
