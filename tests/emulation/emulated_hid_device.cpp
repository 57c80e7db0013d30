#include "tests/emulation/emulated_hid_device.h"

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <cstdio>
#include <utility>

#include <linux/hidraw.h>
#include <sys/ioctl.h>

namespace ghostforce {
namespace {

// Three axes in report 1: the program looks at what the device is for and no further.
std::string report_descriptor(std::uint8_t usage) {
  return {'\x05', '\x01', '\x09', static_cast<char>(usage),
          '\xA1', '\x01', '\x85', '\x01',
          '\x16', '\xA2', '\xFE', '\x26',
          '\x5E', '\x01', '\x09', '\x30',
          '\x09', '\x31', '\x09', '\x32',
          '\x75', '\x10', '\x95', '\x03',
          '\x81', '\x06', '\xC0'};
}

}  // namespace

class EmulatedHidDevice::File final : public OpenFile {
 public:
  explicit File(EmulatedHidDevice& device) : device_(device) {
    const std::lock_guard lock(device_.mutex_);
    is_unplugged = !device_.is_plugged_;
    device_.files_.push_back(this);
  }

  ~File() override {
    const std::lock_guard lock(device_.mutex_);
    std::erase(device_.files_, this);
  }

  CallResult ioctl(const CallerMemory& memory, unsigned long request, std::uintptr_t argument) override {
    const std::lock_guard lock(device_.mutex_);
    if (is_unplugged) return CallResult::failure(ENODEV);
    const std::string& descriptor = device_.descriptor_;
    if (request == HIDIOCGRDESCSIZE) {
      const int size = static_cast<int>(descriptor.size());
      return memory.store(argument, &size, sizeof size) ? CallResult{} : CallResult::failure(EFAULT);
    }
    if (request == HIDIOCGRDESC) {
      const std::uintptr_t bytes = argument + offsetof(hidraw_report_descriptor, value);
      return memory.store(bytes, descriptor.data(), descriptor.size()) ? CallResult{} : CallResult::failure(EFAULT);
    }
    return CallResult::failure(ENOTTY);
  }

  CallResult read(const CallerMemory& memory, std::uintptr_t into, std::size_t size) override {
    const std::lock_guard lock(device_.mutex_);
    if (is_unplugged) return CallResult::failure(ENODEV);
    if (device_.reports_.empty()) return CallResult::failure(EAGAIN);
    const std::vector<std::uint8_t> report = std::move(device_.reports_.front());
    device_.reports_.pop_front();
    device_.file_.terminal->set_readable(!device_.reports_.empty());
    const std::size_t taken = std::min(size, report.size());
    return memory.store(into, report.data(), taken) ? CallResult{static_cast<long>(taken), 0}
                                                    : CallResult::failure(EFAULT);
  }

  bool is_unplugged = false;  // for good, even if the device comes back: that is another file

 private:
  EmulatedHidDevice& device_;
};

EmulatedHidDevice::EmulatedHidDevice(TestBed& bed, UsbId id, std::string name, std::uint8_t usage)
    : bed_(bed), id_(id), name_(std::move(name)), descriptor_(report_descriptor(usage)) {}

EmulatedHidDevice::~EmulatedHidDevice() {
  unplug();
  // Ends the files that are still open.
  past_files_.clear();
  file_.door.reset();
}

void EmulatedHidDevice::plug() {
  unplug();
  const std::string number = std::to_string(bed_.next_address());
  DeviceFile file =
      bed_.make_file("/dev/hidraw" + number, [this](const CallerMemory&) { return std::make_unique<File>(*this); });
  {
    const std::lock_guard lock(mutex_);
    if (file_.door) past_files_.push_back(std::move(file_));
    file_ = std::move(file);
    reports_.clear();
    is_plugged_ = true;
  }
  char ids[64];
  std::snprintf(ids, sizeof ids, "%04X:%04X", unsigned{id_.vendor}, unsigned{id_.product});
  char long_ids[64];
  std::snprintf(long_ids, sizeof long_ids, "0003:0000%04X:0000%04X", unsigned{id_.vendor}, unsigned{id_.product});
  char attributes[128];
  std::snprintf(attributes, sizeof attributes, "A: idVendor=%04x\\n\nA: idProduct=%04x\\n\n", unsigned{id_.vendor},
                unsigned{id_.product});
  const std::string device = std::string(TestBed::hub) + "/1-" + number;
  const std::string interface = device + "/1-" + number + ":1.0";
  const std::string hid = interface + "/0003:" + ids + ".0001";
  const std::string raw = hid + "/hidraw/hidraw" + number;
  syspaths_ = {device, interface, hid, raw};
  bed_.add("P: " + device + "\nE: DEVTYPE=usb_device\nE: SUBSYSTEM=usb\nA: busnum=1\\n\nA: devnum=" + number +
           "\\n\nA: speed=12\\n\nA: bConfigurationValue=1\\n\n" + attributes + "A: bcdDevice=0100\\n\n" +
           "A: manufacturer=3Dconnexion\\n\nA: product=" + name_ + "\\n\n");
  bed_.add("P: " + interface + "\nE: DEVTYPE=usb_interface\nE: SUBSYSTEM=usb\nA: bInterfaceNumber=00\\n\n");
  bed_.add("P: " + hid + "\nE: SUBSYSTEM=hid\nE: HID_ID=" + long_ids + "\nE: HID_NAME=3Dconnexion " + name_ +
           "\nE: HID_UNIQ=\nE: HID_PHYS=usb-1/input0\nH: report_descriptor=" + hex_of(descriptor_) + "\n");
  bed_.add("P: " + raw + "\nE: DEVNAME=" + file_.path + "\nE: SUBSYSTEM=hidraw\nA: dev=" + file_.number() +
           "\\n\nL: device=../../../0003:" + ids + ".0001\n");
}

void EmulatedHidDevice::unplug() {
  {
    const std::lock_guard lock(mutex_);
    if (!is_plugged_) return;
    is_plugged_ = false;
    for (File* const file : files_) file->is_unplugged = true;
  }
  bed_.remove_name(file_.path);
  file_.terminal->hang_up();
  for (auto path = syspaths_.rbegin(); path != syspaths_.rend(); ++path) bed_.remove(*path);
}

void EmulatedHidDevice::forget_what_it_is() {
  bed_.make_unreadable("/sys" + syspaths_[2] + "/uevent");
  bed_.make_unreadable("/sys" + syspaths_[2] + "/report_descriptor");
}

void EmulatedHidDevice::send(std::vector<std::uint8_t> report) {
  const std::lock_guard lock(mutex_);
  if (!is_plugged_) return;
  reports_.push_back(std::move(report));
  file_.terminal->set_readable(true);
}

}  // namespace ghostforce
