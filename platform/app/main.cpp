#include "app/commands.h"
#include "app/supervised.h"

int main(int argc, char** argv) { return lacuna::run_supervised(argc, argv, lacuna::run_program); }
