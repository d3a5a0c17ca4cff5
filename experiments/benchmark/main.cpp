#include "commands/commands.h"

int main(int argc, char** argv) { return hidden_effects::run_program(argc, argv); }
