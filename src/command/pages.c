/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What is said of each command as a whole, and what the examples of all commands run after. A command's forms say the
 * rest, in its own file. Topics are listed in the order in which they first stand here. */
#include "command/commands.h"

#include "base/table.h"

static const command_page pages[] = {
    {"species", "Model", "Declares a kind of cell: its shape, size and density",
     "A model is made of species; growth, division and links are given to a species by its name. A species is also a "
     "group, that of its cells, and a truth value of each cell in expressions.",
     "growth division link create_cells"},
    {"growth", "Model", "Sets how the cells of a species grow",
     "Without it they do not. Naming the law again amends what is named; another law takes its place.",
     "division grow run"},
    {"division", "Model", "Sets when and how the cells of a species divide",
     "Without it they never do. A cell divides once its mass exceeds that at division, which each draws at its birth "
     "where it is a distribution. Mother and daughter have half the mass each; the mother keeps her id, daughters "
     "count on; the daughter draws her own diameter.",
     "growth species run"},
    {"dimension", "Model", "Sets whether cells move in space or in a plane", NULL, "create_cells substratum"},
    {"substratum", "Model", "Puts a plane under the scene",
     "The bulk is above it. Without it space is open on all sides.", "force region"},
    {"force", "Model", "Switches a force on, and sets its parameters",
     "A force that is not named is neither computed nor stored. Naming it again amends the named keywords; 'off' takes "
     "it out.",
     "substratum link accuracy"},
    {"link", "Model", "Sets the springs inside cells and between them",
     "Energies carry their factor: E = k/2 (L - L_rest)^2; LAMMPS's harmonic bonds leave the 1/2 out.",
     "species force"},
    {"region", "Scene", "Names a part of space",
     "A region is a place to create cells in, and a group of the cells whose centre is inside.",
     "create_cells delete_cells"},
    {"group", "Scene", "Names a set of cells",
     "Every species and region is a group already, and all is every cell. A group is a truth value of each cell in "
     "expressions.",
     "region delete_cells analyze"},
    {"create_cells", "Scene", "Puts new cells into the scene", "All of them or none.", "species region set"},
    {"attach", "Scene", "Lets cells arrive from outside at a rate", NULL, "create_cells region run"},
    {"delete_cells", "Scene", "Takes cells out", "Their links go with them.", "create_cells set"},
    {"set", "Scene", "Sets a property of cells from a formula", NULL, "create_cells delete_cells variable"},
    {"clear", "Scene", "Empties the scene", NULL, "read_restart"},
    {"run", "Running", "Grows and relaxes in cycles, with the output that is due",
     "In a cycle every cell grows for DT, cells that are due divide, and the colony relaxes; then output is written, "
     "commands of 'every' run, and 'until' is judged. A cycle happens whole or not at all: after an error or an "
     "interruption the scene is that of the last whole cycle. The step is the number of cycles.",
     "grow relax thermo dump restart"},
    {"grow", "Running", "Lets every cell grow once",
     "A primitive: run repeats it, and writes output, which this does not.", "run growth division"},
    {"relax", "Running", "Lets the cells move under their forces",
     "A primitive: run repeats it, and writes output, which this does not.", "run accuracy integrator force"},
    {"accuracy", "Running", "Chooses how exactly the motion is solved", NULL, "tradeoff integrator relax"},
    {"integrator", "Running", "Chooses the method of the relaxation in detail", NULL, "accuracy relax"},
    {"tradeoff", "Running", "Measures on this scene how exact and how dear each preset of accuracy is",
     "Every preset begins from the scene as it stands, which is afterwards as it was, to the bit: seeds, ids, links, "
     "clock, outputs and undo.",
     "accuracy integrator relax run"},
    {"neighbor", "Running", "Sets how neighbours are found", NULL, "force threads"},
    {"threads", "Running", "Sets how many processor cores are used", NULL, "neighbor"},
    {"seed", "Running", "Seeds every random number", NULL, "units variable"},
    {"units", "Running", "Sets the units of bare numbers", NULL, "seed"},
    {"thermo", "Output", "Sets how often a run prints its table", NULL, "thermo_style thermo_modify run"},
    {"thermo_style", "Output", "Chooses the columns of a run's table", NULL, "thermo thermo_modify analyze"},
    {"thermo_modify", "Output", "Changes how a run's table is written", NULL, "thermo thermo_style"},
    {"analyze", "Output", "Measures a group of cells, now or along a run",
     "ID is a value from then on, in expressions and columns; ID.FIELD is one of its fields. 'analyze ID off' forgets "
     "it.",
     "thermo_style variable"},
    {"dump", "Output", "Writes cells or links to files along a run",
     "A frame is written before the first cycle and whenever it is due. * in FILE is the step: one file a frame. A "
     "step "
     "is written once.",
     "write_dump dump_modify undump"},
    {"write_dump", "Output", "Writes cells or links to a file at once", NULL, "dump"},
    {"plot", "Output", "Draws tables of runs and ensembles, histograms and profiles", NULL, "thermo_style analyze"},
    {"dump_modify", "Output", "Changes a dump", NULL, "dump undump"},
    {"undump", "Output", "Ends a dump", NULL, "dump dump_modify"},
    {"restart", "Restarting", "Writes restart files while a run goes on", NULL, "write_restart read_restart run"},
    {"write_restart", "Restarting", "Writes the whole scene to a file", NULL, "read_restart restart"},
    {"read_restart", "Restarting", "Goes on from a restart file", NULL, "write_restart restart"},
    {"write_data", "Restarting", "Writes the cells to a table", NULL, "read_data create_cells write_restart"},
    {"read_data", "Restarting", "Puts the cells of a table into the scene", NULL, "write_data create_cells"},
    {"variable", "Language", "Names a text, a formula or a list", NULL, "print include"},
    {"print", "Language", "Prints a text", NULL, "variable log"},
    {"include", "Language", "Runs a script at this place", NULL, "variable"},
    {"expect", "Language", "Stops unless something holds", "The language's own tests are made of it: sarcina -test.",
     "expect_error"},
    {"expect_error", "Language", "Stops unless a command fails as it should", NULL, "expect"},
    {"help", "Program", "Explains commands, values, functions and the language", NULL, "apropos info"},
    {"apropos", "Program", "Finds what has to do with a word", NULL, "help"},
    {"info", "Program", "Tells what is in the scene, or where the time went", NULL, "help log"},
    {"echo", "Program", "Shows commands as they run", NULL, "log"},
    {"log", "Program", "Chooses the log file", NULL, "echo print"},
    {"warn", "Program", "Sets what happens to warnings", NULL, "log"},
    {"shell", "Program", "Runs a command of the system", NULL, "log"},
    {"quit", "Program", "Ends the script or the session", NULL, "clear"},
    {"undo", "Prompt", "Takes back the last command", NULL, "save clear"},
    {"save", "Prompt", "Writes the session as a script", NULL, "undo write_restart"},
    {"show", "Prompt", "Draws the colony in the terminal", NULL, "watch write_dump"},
    {"watch", "Prompt", "Shows the colony or values while a run goes on", NULL, "show thermo"},
    {"edit", "Prompt", "Opens the last command in an editor and runs it", NULL, "undo"},
};

static const char prelude[] = "species       ecoli rod diameter 0.75um\n"
                              "species       cf coccus\n"
                              "growth        ecoli exponential rate 1.23/h\n"
                              "growth        cf exponential rate 1/h\n"
                              "division      ecoli midpoint mass 2.45e-15kg\n"
                              "division      cf random mass 6e-16kg\n"
                              "substratum    plane\n"
                              "force         collision\n"
                              "force         damping\n"
                              "link          internal ecoli\n"
                              "region        box block -5um 5um -5um 5um 0 5um\n"
                              "create_cells  ecoli single 0 0 0 orient x gap 0\n"
                              "create_cells  cf single 0 3um 0 gap 0\n"
                              "write_restart colony.rst\n";

static const command_file files[] = {
    {"scene.in", "force damping k 2e-13N.s/m\n"},
    {"cells.csv", "species,x[um],y[um],z[um],mass[kg],ux,uy,uz\n"
                  "ecoli,-4,0,0.375,1.2e-15,1,0,0\n"
                  "ecoli,4,0,0.375,2e-15,0,1,0\n"},
    {"ecoli.ensemble.csv", "step,time,quantity,unit,runs,n,mean,ci95,sd,min,max\n"
                           "0,0,cells,,3,3,1,0,0,1,1\n"
                           "0,0,thickness,m,3,3,3.75e-7,0,0,3.75e-7,3.75e-7\n"
                           "5,1200,cells,,3,3,2.3,1.4,0.6,2,3\n"
                           "5,1200,thickness,m,3,3,5e-7,1.2e-7,5e-8,4.5e-7,5.5e-7\n"
                           "5,1200,lengths.low[1],m,3,3,2e-6,0,0,2e-6,2e-6\n"
                           "5,1200,lengths.high[1],m,3,3,4e-6,0,0,4e-6,4e-6\n"
                           "5,1200,lengths.fraction[1],,3,3,1,0,0,1,1\n"},
};

void command_pages(command_table *t) {
    command_add_pages(t, pages, TABLE_COUNT(pages));
    command_set_prelude(t, prelude, files, TABLE_COUNT(files));
}
