#include "app/shell/receipt_writing.h"

namespace ghostforce {

void write_receipt(const Receipt&, const FilePainter&, const std::string&) {}

}  // namespace ghostforce
