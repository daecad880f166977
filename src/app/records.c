/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "app/records.h"

#include "app/options.h"
#include "script/help.h"

#include <stdlib.h>

char *records_json(const command_table *t) {
    page p = {0};
    option_text o;
    char *rest = help_json(t);
    page_put(&p, "{");
    help_json_member(&p, "program", "sarcina");
    help_json_member(&p, "version", SARCINA_VERSION);
    page_put(&p, ",\n\"options\": [");
    for (size_t i = 0; options_list(i, &o); i++) {
        page_put(&p, "%s\n  {", i ? "," : "");
        help_json_member(&p, "name", o.name);
        help_json_member(&p, "takes", o.takes);
        help_json_member(&p, "summary", o.summary);
        page_put(&p, "}");
    }
    page_put(&p, "],\n%s}\n", rest);
    free(rest);
    return p.chars;
}
