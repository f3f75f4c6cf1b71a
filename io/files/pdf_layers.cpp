#include "io/files/pdf_layers.h"

#include <cassert>
#include <exception>
#include <qpdf/Pipeline.hh>
#include <qpdf/QPDF.hh>
#include <qpdf/QPDFObjectHandle.hh>
#include <qpdf/QPDFPageDocumentHelper.hh>
#include <qpdf/QPDFWriter.hh>

namespace dapple {
namespace {

using Object = QPDFObjectHandle;

// Into a stream. What the stream throws is kept: the library writes once more while it is destroyed.
class IntoStream : public Pipeline {
 public:
    explicit IntoStream(std::ostream& out) : Pipeline("drawing", nullptr), out_(out) {}

    void write(const unsigned char* bytes, std::size_t size) override {
        if (thrown_) return;
        try {
            out_.write(reinterpret_cast<const char*>(bytes), static_cast<std::streamsize>(size));
        } catch (...) {
            thrown_ = std::current_exception();
        }
    }
    void finish() override {}
    void check() const {
        if (thrown_) std::rethrow_exception(thrown_);
    }

 private:
    std::ostream& out_;
    std::exception_ptr thrown_;
};

// The page's content, to be drawn wherever it is asked for while the group is shown.
Object form_of(QPDFPageObjectHelper& page, const Object& group, bool as_one) {
    Object form = page.getObjectHandle().getKey("/Contents");
    Object dictionary = form.getDict();
    dictionary.replaceKey("/Type", Object::newName("/XObject"));
    dictionary.replaceKey("/Subtype", Object::newName("/Form"));
    dictionary.replaceKey("/BBox", page.getMediaBox());
    dictionary.replaceKey("/Resources", page.getAttribute("/Resources", false));
    dictionary.replaceKey("/OC", group);
    if (as_one) dictionary.replaceKey("/Group", Object::parse("<< /S /Transparency /CS /DeviceRGB >>"));
    return form;
}

}  // namespace

void write_as_layers(std::ostream& out, std::string_view pages, const std::vector<PdfLayer>& layers) {
    QPDF pdf;
    pdf.processMemoryFile("drawing", pages.data(), pages.size());
    QPDFPageDocumentHelper document(pdf);
    std::vector<QPDFPageObjectHelper> all = document.getAllPages();
    assert(all.size() == layers.size());

    Object groups = Object::newArray(), forms = Object::newDictionary();
    std::string content;
    for (std::size_t i = 0; i < all.size(); ++i) {
        Object group = pdf.makeIndirectObject(Object::newDictionary());
        group.replaceKey("/Type", Object::newName("/OCG"));
        group.replaceKey("/Name", Object::newUnicodeString(layers[i].name));
        groups.appendItem(group);
        const std::string name = "/Layer" + std::to_string(i + 1);
        forms.replaceKey(name, form_of(all[i], group, layers[i].multiplies));
        content += (layers[i].multiplies ? "/Over gs " : "/Hiding gs ") + name + " Do\n";
    }
    Object resources = Object::newDictionary();
    resources.replaceKey("/XObject", forms);
    resources.replaceKey("/ExtGState",
                         Object::parse("<< /Over << /BM /Multiply >> /Hiding << /BM /Normal >> >>"));
    Object page = all.front().getObjectHandle();
    page.replaceKey("/Resources", resources);
    page.replaceKey("/Contents", Object::newStream(&pdf, content));
    for (std::size_t i = 1; i < all.size(); ++i) document.removePage(all[i]);

    // All shown at first, listed as programs list layers: the lowest last.
    Object order = Object::newArray(), shown = Object::newDictionary(), properties = Object::newDictionary();
    for (int i = groups.getArrayNItems(); i-- > 0;) order.appendItem(groups.getArrayItem(i));
    shown.replaceKey("/BaseState", Object::newName("/ON"));
    shown.replaceKey("/Order", order);
    properties.replaceKey("/OCGs", groups);
    properties.replaceKey("/D", shown);
    pdf.getRoot().replaceKey("/OCProperties", properties);

    IntoStream pipeline(out);
    QPDFWriter writer(pdf);
    writer.setOutputPipeline(&pipeline);
    writer.setObjectStreamMode(qpdf_o_disable);
    writer.setDecodeLevel(qpdf_dl_none);
    writer.setCompressStreams(false);
    writer.setDeterministicID(true);
    writer.setMinimumPDFVersion("1.5");
    writer.write();
    pipeline.check();
}

}  // namespace dapple
