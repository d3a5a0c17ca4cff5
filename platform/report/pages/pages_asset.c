/* The bundle of report/pages/web as bytes of the program. LACUNA_PAGES_FILE is its path. */
__asm__(
    ".section .rodata\n"
    ".global lacuna_pages_begin\n"
    ".global lacuna_pages_end\n"
    "lacuna_pages_begin:\n"
    ".incbin \"" LACUNA_PAGES_FILE "\"\n"
    "lacuna_pages_end:\n"
    ".byte 0\n"
    ".previous\n");

typedef int lacuna_not_an_empty_file;
