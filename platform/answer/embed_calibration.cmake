# Writes OUTPUT, a C++ source that holds the file INPUT: cmake -DINPUT=... -DOUTPUT=... -P embed_calibration.cmake
file(READ ${INPUT} text)
file(WRITE ${OUTPUT} "// Made from calibration.json by embed_calibration.cmake.\nnamespace lacuna {\n
extern const char* const kCalibrationDocument;
const char* const kCalibrationDocument = R\"~json~(${text})~json~\";\n
}  // namespace lacuna\n")
