/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The topics of the language. What a paragraph claims its example shows, where a line can. */
#include "script/topic.h"

#include "base/table.h"

#include <string.h>

static const topic_part lines[] = {
    {"A script is lines of text. A line is one command: a name, its arguments, all parted by blanks or tabs. The "
     "command "
     "chooses by its record how each stretch behind it is read: as a word, a number, an expression, a text. Names are "
     "lower-case and case counts; a slip is answered with 'did you mean'.",
     "species       pink coccus color pink     # a comment goes to the end of the line\n"
     "create_cells  pink single 0 -3um 0 mass 6e-16kg gap 0",
     "created 1 cell of pink: 3 in all"},
    {"An & at the end of a line continues it, also before a comment (which LAMMPS takes for text; here it is warned "
     "of). "
     "Lines of comment within a continued command are skipped. A line that ends in && ends in the operator, which "
     "stays, "
     "and goes on too.",
     "create_cells ecoli single 0 6um 0 &\n"
     "    # where it lies\n"
     "    orient x gap 0",
     "created 1 cell of ecoli: 3 in all"},
    {"\"...\" and '...' quote one argument; \"\"\"...\"\"\" quotes one over several lines. Inside, # is no comment and "
     "other "
     "quotes stand for themselves; there are no backslash escapes. A closing quote is followed by a blank. A quote "
     "within "
     "a word, as in it's, is a letter.",
     "print \"it's # no comment\"\n"
     "print 'say \"hi\"'",
     "it's # no comment\nsay \"hi\""},
    {"Tabs, Windows line ends, a byte order mark and a last line without an end are all fine. Texts and comments may "
     "hold any "
     "UTF-8; elsewhere a letter that is not ASCII is an error that names it, but for the units um written with a micro "
     "sign and exponents written as superscripts.",
     NULL, NULL},
    {"A script is checked whole before its first command runs, branches that are not reached included, so that no "
     "mistake "
     "in line 200 shows after three hours. sarcina -check FILE does only that. At the prompt each command is checked "
     "by "
     "itself. A command that fails leaves the scene as it was.",
     NULL, NULL},
};

static const topic_part numbers[] = {
    {"A number carries its unit, with no blank between: 0.75um, 4min, 1.23/h, 5e-11N/m, 1e-13N.s/m, 1010kg/m3. Every "
     "argument knows its dimension and refuses others. UDUNITS-2 knows the units; products are written with a point, "
     "quotients with a slash, exponents behind the unit. A number without a unit is in the script's units: SI, or um, "
     "pg "
     "and s after 'units bio'.",
     "species a rod diameter 0.75um\n"
     "species b rod diameter 7.5e-7\n"
     "expect_error \"takes a length, not '1.23/h' (rate)\" \"species a rod diameter 1.23/h\"",
     NULL},
    {"What looks like a number must be one to its last letter: 1.5.2m, 0x10, inf and 5um@3 are errors. Whole numbers "
     "may be "
     "written 1e6. Records give ranges; what is outside is an error, what is unlikely (a cell of 1 m) a warning.",
     "expect_error \"not a number\" \"species a rod diameter 0x10\"", NULL},
    {"A percentage is of the natural whole: mass 50% of the mass at division, sd 5% of the mean, probability 90% of "
     "one.",
     "create_cells ecoli single 0 6um 0 mass 50% gap 0", NULL},
    {"Where a distribution may stand: VALUE; VALUE sd SD; uniform LO HI; normal MEAN SD; lognormal MEDIAN GSD, GSD the "
     "geometric standard deviation. It is drawn anew for each cell.",
     "growth ecoli exponential rate 1.23/h sd 0.277/h\n"
     "growth cf exponential rate uniform 0.5/h 1.5/h\n"
     "species e rod diameter lognormal 0.75um 1.1\n"
     "create_cells ecoli single 0 6um 0 mass normal 75% 5% gap 0",
     NULL},
    {"Dimensions, and usual units of each:", NULL, NULL},
};

static const topic_part dollars[] = {
    {"$x (one letter), ${name} and $(EXPR) are replaced before the command reads its words, once. $(EXPR:%.3f) says "
     "the "
     "format, one of %d %i %f %e %g with flags, width and digits; without one the number is written so that it reads "
     "back "
     "to the bit, with its unit. $$ is a $. $ and several letters are an error: LAMMPS takes $seed for $s and 'eed'.",
     "variable d default 2um\n"
     "print \"${d} is $(2um/1nm:%.0f) nm; $(sqrt(2):%.3f); $$5\"\n"
     "expect_error \"write $${seed}\" 'print \"$seed\"'",
     "2um is 2000 nm; 1.414; $5"},
    {"A replaced number is one operand, sign and unit included: with x = -2, $x^2 is 4.",
     "variable n default -2\n"
     "print \"$(${n}^2:%d) $(-2^2:%d)\"",
     "4 -4"},
    {"Commands given as text (every, then, expect_error), bodies of blocks and their conditions are replaced when they "
     "run, "
     "each time anew; all else when the line is read. ${here} is the folder of the running script.",
     "for i in 1..2\n"
     "    print \"pass $i\"\n"
     "end",
     "pass 1\npass 2"},
    {"A variable's first setting by 'variable NAME default' wins: -var NAME TEXT on the command line, a loop, or a "
     "script "
     "that sets it before it includes another. A -var that nothing reads is an error.",
     "variable seed default 7\n"
     "variable seed default 8\n"
     "print ${seed}",
     "7"},
};

static const topic_part expressions[] = {
    {"From loose to tight: ||; &&; == != < <= > >= (which do not chain: write a < b && b < c); + -; * / and % (C's "
     "remainder); - + ! in front; ^ (from the right, tighter than a minus before it). Names are values, variables, "
     "groups, "
     "species, regions and analyses; NAME.FIELD is a field, NAME[N] the N-th of a list or the value of cell N; "
     "FUNCTION(...) a call.",
     "print \"$(-2^2:%d) $(2^3^2:%d) $(7 % 3:%d) $(1 < 2 && 2 < 3)\"\n"
     "print \"$(ellipse.major/1um:%.2f) um; cell 2 is at $(y[2]/1um:%.1f) um\"",
     "-4 512 1 1\n4.00 um; cell 2 is at 3.0 um"},
    {"Values carry their dimension, and what does not fit is an error. A unit stands directly on a number, and only "
     "one: "
     "4min, 2um2, 1.23/1h, 5e-11N/1m. Names of units alone are no values, so that C, h and s are free for variables. "
     "Pure numbers adapt to what they meet: thickness > 0.75 compares in the script's units; thickness/1um is right in "
     "all.",
     "print \"$(4min/1s:%d) $(2um^2/1um2:%d) $(1.23/1h*1h:%.2f)\"\n"
     "expect_error \"'+' between length and time\" 'print \"$(1um + 1s)\"'\n"
     "expect_error \"a unit stands on a number\" 'print \"$(1.23/h)\"'",
     "240 4 1.23"},
    {"A value of each cell stands where cells are asked: in columns of dumps, colours, where, groups. Where one number "
     "is "
     "due, reduce it: mean(z), max(overlap), count(z > 1um), quantile(0.99, speed), each with an optional where. A "
     "species, group or region is true for its cells.",
     "print \"$(mean(length where ecoli)/1um:%.2f) um, $(count(cf && y > 1um)) cell\"\n"
     "expect_error \"value per cell\" 'print \"$(z)\"'",
     "3.00 um, 1 cell"},
    {"What is undefined (the orientation of one cell) is nan: in tables, and false in comparisons. Division by zero "
     "and what "
     "is not finite are errors. Texts compare by == and !=.",
     "print \"$(species[1] == 'ecoli')\"", "1"},
    {"In lists (columns) an expression is one word: blanks only within parentheses or quotes. Elsewhere it takes as "
     "much as "
     "can belong to it, and ends before the first word that cannot; quotes around the whole of it are allowed.",
     "thermo_style custom step time/1h mean(z, ecoli)/1um \"max(length)/1um\"\n"
     "run 1 grow 4min relax 0.1s until thickness > 0.75um",
     NULL},
    {"Random numbers of expressions (random, normal, poisson) come from a stream of the script's own and leave that of "
     "the "
     "cells alone.",
     "variable n equal poisson(3)\n"
     "expect_error \"drawn anew\" \"run 5 grow 4min until n > 3\"",
     NULL},
};

static const topic_part values[] = {
    {"Values of the scene are numbers anywhere. Measures are values by their own name, over all cells; analyze names "
     "one for "
     "a group. Values of each cell stand where cells are asked, or reduced, or as NAME[ID] for one cell. Names of "
     "groups, "
     "species and regions are 1 or 0 for each cell.",
     "print \"$(cells) cells, $(thickness/1um:%.3f) um, $(length[1]/1um:%.2f) um\"", "2 cells, 0.414 um, 3.00 um"},
};

static const topic_part functions[] = {
    {"Functions of numbers, and reductions of the values of cells, or of a list, to one number.",
     "variable t list 1 2 3 4\n"
     "print \"$(hypot(3um, 4um)/1um:%d) $(mean(t)) $(quantile(0.5, t)) $(fraction(ecoli))\"",
     "5 2.5 2.5 0.5"},
};

static const topic_part blocks[] = {
    {"Blocks go over lines and are closed by end, in files, pipes and at the prompt alike. There is no jump, label or "
     "next.",
     "variable n list\n"
     "for i in 1..3\n"
     "    if $i == 2\n"
     "        continue\n"
     "    end\n"
     "    variable n append $i\n"
     "end\n"
     "print \"$(sum(n)) of $(count(n))\"",
     "4 of 2"},
};

static const topic_part names[] = {
    {"Letters, digits and _, a letter or _ first. Variables, analyses, groups, species, regions, values and functions "
     "share "
     "one space of names, so that a name means one thing everywhere; a clash is an error where it is made. IDs of "
     "dumps "
     "are free. Reserved are all now off where vs file every until approx then yes no INF. Names of commands are free: "
     "a "
     "variable may be called grow.",
     "expect_error \"value of the cells already\" \"variable x default 3\"\n"
     "expect_error \"already a species\" \"group ecoli where z > 1um\"",
     NULL},
    {"LAMMPS's v_NAME and c_NAME are understood as NAME.", "variable h0 equal 2um\nprint \"$(v_h0/1um:%d)\"", "2"},
};

static const topic_part arguments[] = {
    {"Arguments in their place come first, in order; keywords follow in any order, each once. All are read and checked "
     "before anything changes. What a record calls required must be there the first time.",
     "expect_error \"twice\" \"force collision k 1e-10N/m k 2e-10N/m\"\n"
     "expect_error \"did you mean 'reach'\" \"force collision raech 1.01\"",
     NULL},
    {"The same head again amends the keywords that are named and leaves the others. off in the place of the arguments "
     "takes "
     "out what the head names.",
     "force dlvo ces 1e-22N.m kappa 5e7/m\n"
     "force dlvo kappa 4e7/m\n"
     "force dlvo off",
     NULL},
    {"Wherever 'every' or an interval stands, N is cycles or a time. In names of output files * is the step. In the "
     "place of "
     "a species * is every species so far. GROUP is all, a species, a region, or a group.",
     "thermo 20min\n"
     "dump d all csv 2 cells.*.csv id x y\n"
     "link internal * k 5e-11N/m",
     NULL},
};

static const topic_part colors[] = {
    {"A colour is one of these names, or \"#rrggbb\" or \"#rgb\" in quotes, since # begins a comment. Where a colour "
     "may be "
     "computed, a value of each cell stands in its place: its numbers go through a map of colours (viridis plasma "
     "magma "
     "inferno cividis coolwarm gray).",
     "species blue coccus color \"#377eb8\"\n"
     "write_dump all image a.png z map plasma size 320 240\n"
     "write_dump all image b.png orange background \"#102030\" size 320 240",
     NULL},
};

static const topic_part accuracy[] = {
    {"How exactly the motion is solved, from quick to exact. A preset chooses a method and its step and never physics: "
     "growth "
     "step, relaxation time and contact law are the script's. What each costs and changes on colonies and flocs of "
     "several sizes: help trade. On yours: tradeoff.",
     "accuracy paper", NULL},
};

static const topic_part trade[] = {
    {"What the presets of accuracy cost and change, measured by 'tradeoff'. Each case grows a colony by balanced, and "
     "from "
     "there every preset makes one growth step and relaxation of 1 s (evaluations of the force, error of the "
     "particles' "
     "positions), and 10 cycles from each of 5 seeds or more (differences from the most exact preset, paired by seed, "
     "with "
     "intervals of 95 % for all quantities of a preset together; equivalent: within 2 %, by two one-sided tests at 5 "
     "%). "
     "chaos: a displacement of 1e-9 diameters changes the end as much as the preset does. The command of each is in "
     "examples/tradeoff/README.md; scripts/tradeoff makes all of it anew.",
     NULL, NULL},
    {"Growth step and relaxation time are physics, no part of a preset, and no way to speed: 0.5 s of relaxation in "
     "place "
     "of 1 s makes the radius of gyration of 3,000 rods 26.1 um in place of 28.4 um, 3 s make it 32.0 um.",
     NULL, NULL},
};

static const topic_part integrators[] = {
    {"The methods that accuracy chooses from, for those who want another, or another step or tolerance.",
     "integrator verlet step 1ms", NULL},
    {"inertia C, for verlet and euler without a step of their own: at the time t of a relaxation every mass counts as "
     "C t k_d, where that is more (k_d: damping; of the heaviest particle, the others as much heavier; at most 10 "
     "times). Steps grow as its root. A mode that has not decayed by then has a rate of 1/t or less, and inertia "
     "changes that by no more than C: what is lost is what has passed. What it leaves: at 2,000 rods of E. coli a "
     "growth "
     "step makes the radius of gyration 0.02, 0.05, 0.09 % too large at C 0.05, 0.1, 0.2, of the 1.2 % it grows. "
     "Without damping, and with flexible cells, masses stay.",
     "integrator verlet inertia 0.1", NULL},
    {"newton goes to rest, for 'relax to F': it minimises the energy of all terms. Each step solves (mu + K) dx = F by "
     "conjugate gradients, K the stiffness of all that acts, without the parts that would make it negative; mu is k_d "
     "/ "
     "tau of an implicit step of overdamped motion and falls with the largest force (Kelley & Keyes 1998, SIAM J. "
     "Numer. "
     "Anal. 35:508). A step moves no particle by more than half its radius, and lowers the energy. There is no "
     "inertia: "
     "two cocci end where contact does, at 1.01 D. Neither stiffness, however unequal, nor mass nor damping counts. "
     "Its "
     "steps are no time: 'relax T', 'within T' and tradeoff are refused, the time relaxed stays, and all is still "
     "afterwards. Links form and break before it begins and wherever it has come to rest; where some did, it goes on. "
     "It finds a rest near by, not the state at a time, and not always the one that motion leads to: growth and "
     "relaxation times are physics, and runs that grow by 'relax to F' are another model. Where there is no rest it "
     "stops with a warning that names force, cell and term: when in 300 steps neither the largest force has fallen by "
     "a "
     "tenth nor the energy by a hundredth of what it takes that force to move a particle by its radius or by "
     "a thousandth of itself, or in 20,000 "
     "the force has not. With contact closest that is the rule where links or walls press rods together: its energy is "
     "the larger of those of both ends, with a crease where the rods are parallel; they rest on the crease, where the "
     "force jumps from one end to the other and is nowhere 0. Contact regularised has no crease.",
     "integrator newton\nrelax to 1e-19N", NULL},
    {"Force evaluations, and products of K with a vector, to 1e-19 N; evaluations of balanced and paper; to 1e-24 N, "
     "by newton. 150 rods in a crowd on a plane with DLVO: 783 + 6,487; 1,800, 122,593; 2,435 + 43,041. In free space: "
     "27 + 763; 121, 397; 44 + 794. 60 linked cocci: 6 + 11; 53, 1,116; 55 + 1,443. 1,000: 6 + 11; 53, 10,790; 50 + "
     "1,482. 12 flexible cells: 6 + 4; 28, -; 84 + 1,337. Four rods of 1 mm across each other: 9 + 13; 85, 17; 13 + "
     "17. 100 cocci in a point: 23 + 601; 46, 238; 68 + 674. 100 rods: 39 + 1,117; 52, 309; 74 + 1,318. Where cells "
     "only part, dynamics is as cheap; where the soft follows the stiff, or 1e-24 N are due, it is not. Behind it is "
     "FIRE: help methods. SARCINA_TEST_TIER=full build/release/tests/minimising prints the numbers.",
     NULL, NULL},
    {"What each costs and how exact it is, and which were tried and left out: help methods.", NULL, NULL},
};

static const topic_part methods[] = {
    {"What the integrators cost and how exact they are, in one growth step and one relaxation of 1 s, measured by "
     "'tradeoff' on three scenes: evaluations of the force, processor time as a multiple of that of 'accuracy paper', "
     "root mean square error of positions against a converged reference. *: on the Pareto front of that scene, for no "
     "other has fewer evaluations and a smaller error; r: within twice of what is known of the reference. A name alone "
     "takes the step or tolerance that is its own. One "
     "relaxation is one draw: whether a link is made or a contact opens decides some rows. examples/tradeoff/README.md "
     "has the commands, tables and diagrams; scripts/tradeoff makes all of it anew.",
     "run 2 grow 4min relax 0.1s\n"
     "tradeoff 0.1s among balanced verlet \"verlet step 1ms\" \"bs32 tol 0.01\"",
     NULL},
    {"Left out, by what a prototype measured on a scene of 321 rods, in the same relaxation (evaluations, root mean "
     "square error): overdamped Euler (no inertia at all), steps of 0.2 ms: 5,000, 120 nm, for inertia makes the "
     "motion less stiff. Implicit Euler, steps of 10 ms: 100 solutions that cost as much as 1,600 evaluations, 220 nm. "
     "CVODE's BDF with GMRES, tolerance 1e-3: 15,000, 2 nm. Nonlinear conjugate gradients to rest: 651, 90 nm, and "
     "colonies of 3,000 rods of 22.0 um for 28.4 um. Also behind, without figures: Runge-Kutta-Chebyshev, Rosenbrock, "
     "and RESPA, which takes the contacts more often than the rest. Of inertia that fades: Newmark's damping of stiff "
     "modes took no error away; moving positions back by what grown masses had carried too far was given up, without "
     "figures. Velocities that shrink as the masses grow halve what balanced adds to the radius of gyration in one "
     "growth step of 2,048 rods (0.02 % for 0.04 %, 12 seeds, against steps of 0.5 ms; 0.00 % where they keep momentum "
     "in place of energy), but carry a floc of 88 cells less far: 2.4 nm (5.0 nm) for 1.3 nm; grown from "
     "one cell, colonies of 3,000 rods were the same (-0.01 +- 0.80 %, 16 seeds). "
     "Of minimisers for 'relax to F', FIRE 2.0 (Guenole et al. 2020), in the scenes of newton's figures (help "
     "integrators), evaluations to 1e-19 N: 1,496 for the rods on a plane, 97 for the 60 linked cocci, 78 for the "
     "flexible cells; its inertia carried two cocci on to 1.16 D, past the end of contact at 1.01 D, and it stalled "
     "where contacts are 1e6 times as stiff. The rows:",
     NULL, NULL},
};

static const topic_part forces[] = {
    {"All terms of the force on a particle. Those of springs come with link, the plane with substratum, the others "
     "with "
     "force.",
     NULL, NULL},
};

static const topic_part random_numbers[] = {
    {"Every random number is a function of the seed, its purpose, the cell's id and the step. The same seed gives the "
     "same "
     "bits for any number of threads, after a restart, and by whichever way the commands came: a file, a pipe, -e, "
     "include "
     "or the prompt.",
     "clear\nseed 7", NULL},
};

static const topic_part errors[] = {
    {"An error says file, line and column, shows the line with a caret under the word, says what was due, and often "
     "what to "
     "write instead; the line as it read after $ was replaced, and the loops and includes it stood in, where there are "
     "any. All mistakes of a script are listed before it runs. Warnings are limited and counted; 'warn error' makes "
     "them "
     "errors.",
     "expect_error \"did you mean 'create_cells'\" \"creat_cells ecoli single 0 0 0\"", NULL},
    {"The exit code of sarcina:", NULL, NULL},
};

static const topic_part tests[] = {
    {"expect and expect_error make a script a test of itself. sarcina -test PATH... runs every *.test.in of the files "
     "and "
     "folders given, each in a folder of its own, counts what holds and what does not, and prints N passed, N failed. "
     "A "
     "line '# ref: TABLE.csv rel R column NAME abs A' at the head of a test compares a CSV file that it writes with "
     "TABLE.csv.ref beside the script, number by number.",
     "expect thickness approx 0.414um rel 1%\n"
     "expect_error \"more than 0\" \"species a rod diameter -1um\"",
     NULL},
};

#define TOPIC(id, title_, rows_, words_)                                                                               \
    { #id, title_, id, TABLE_COUNT(id), rows_, words_ }

static const char *const
    line_words[] = {"quotes", "comments", "continuation", "utf-8", NULL},
    *const number_words[] = {"units", "dimensions", "distributions", "percent", "spread", NULL},
    *const dollar_words[] = {"variables", "substitution", "formats", "$", NULL},
    *const expression_words[] = {"operators", "formula", NULL}, *const function_words[] = {"reductions", NULL},
    *const block_words[] = {"loops", "jump", "label", "next", NULL},
    *const argument_words[] = {"keywords", "off", "*", NULL}, *const color_words[] = {"colours", "maps", "map", NULL},
    *const preset_words[] = {"reference", "paper", NULL}, *const trade_words[] = {"cost", "precision", "pareto", NULL},
    *const method_words[] = {"losers", "solvers", NULL},
    *const random_words[] = {"randomness", "reproducibility", NULL},
    *const error_words[] = {"warnings", "exit", "codes", NULL}, *const test_words[] = {"testing", "ref", NULL};

const topic topic_list[] = {
    TOPIC(lines, "Lines, words and quotes", NULL, line_words),
    TOPIC(numbers, "Numbers, units and distributions", topic_row_dimension, number_words),
    TOPIC(dollars, "Variables in a line: what $ does", NULL, dollar_words),
    TOPIC(expressions, "Expressions", NULL, expression_words),
    TOPIC(values, "Values that expressions may name", topic_row_value, NULL),
    TOPIC(functions, "Functions and reductions", topic_row_function, function_words),
    TOPIC(blocks, "Blocks and loops", topic_row_block, block_words),
    TOPIC(names, "Names", NULL, NULL),
    TOPIC(arguments, "What every command obeys", NULL, argument_words),
    TOPIC(colors, "Colours", topic_row_color, color_words),
    {"presets", "Presets of accuracy", accuracy, TABLE_COUNT(accuracy), topic_row_accuracy, preset_words},
    TOPIC(trade, "Speed against accuracy, measured", topic_row_trade, trade_words),
    TOPIC(integrators, "Integrators", topic_row_integrator, NULL),
    TOPIC(methods, "Integrators against each other, measured", topic_row_method, method_words),
    TOPIC(forces, "Terms of the force", topic_row_force, NULL),
    {"random", "Random numbers", random_numbers, TABLE_COUNT(random_numbers), NULL, random_words},
    TOPIC(errors, "Errors, warnings and exit codes", topic_row_exit, error_words),
    TOPIC(tests, "Scripts that test", NULL, test_words),
};
const size_t topic_count = TABLE_COUNT(topic_list);

const topic *topic_find(const char *name) {
    ptrdiff_t row = table_find(topic_list, topic_count, sizeof *topic_list, name);
    if (row >= 0)
        return &topic_list[row];
    for (size_t i = 0; i < topic_count; i++)
        for (const char *const *w = topic_list[i].words; w && *w; w++)
            if (strcmp(*w, name) == 0)
                return &topic_list[i];
    return NULL;
}
