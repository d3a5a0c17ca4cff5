#include "app/commands.h"
#include "app/plain_streams.h"
#include "app/supervised.h"

int main(int argc, char** argv) {
  lacuna::make_streams_plain();
  return lacuna::run_supervised(argc, argv, lacuna::run_program);
}
