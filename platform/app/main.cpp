#include "app/commands.h"

int main(int argc, char** argv) { return lacuna::run_program(argc, argv); }
