/* Quell's C99 API: the same denoiser as quell.hpp, for C programs and for languages that call C.
 *
 * Functions return a status and write results through pointers; no C++ exception crosses them. A pointer that must
 * not be NULL gives QUELL_INVALID_ARGUMENT. The text of the latest failure is kept per thread: quellErrorMessage().
 *
 * Every struct that may grow begins with structSize. QUELL_INIT(object) sets it and makes all else zero, which means
 * the default or "absent" everywhere; use it for results, too. A library takes structs of older headers, whose missing
 * fields count as zero, and of newer ones as long as what it does not know is zero; else QUELL_INVALID_ARGUMENT. It
 * writes no more than structSize bytes.
 *
 * Objects may be used from several threads by turns, not at once; different objects at once. Enumerations are 32-bit
 * integers, so that their size does not depend on the compiler. With QUELL_DECLARATIONS_ONLY defined no function has a
 * body here, for languages that read the header themselves. */
#ifndef QUELL_QUELL_H
#define QUELL_QUELL_H

#include <CL/cl.h>
#include <quell/api.h>
#include <quell/frame_images.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

QUELL_C_API_BEGIN

/* Sets structSize and makes all else of a struct zero, before every use of one that has it. */
#define QUELL_INIT(object)                \
  do {                                    \
    memset(&(object), 0, sizeof(object)); \
    (object).structSize = sizeof(object); \
  } while (0)

/* --- Status and errors ------------------------------------------------------------------------------------------ */

/* What a function returns; QUELL_SUCCESS, or what kind of thing went wrong. */
typedef int32_t quell_status;
enum {
  QUELL_SUCCESS = 0,          /* all went well */
  QUELL_INVALID_ARGUMENT = 1, /* a value, size, layout or handle was refused before anything was launched */
  QUELL_UNKNOWN_SETTING = 2,  /* a method or setting name that does not exist */
  QUELL_OUT_OF_RANGE = 3,     /* a setting, or a camera for half positions, outside its documented range */
  QUELL_NOT_PREPARED = 4,     /* quellDenoise before quellPrepare, or with a size or layout not prepared */
  QUELL_WRONG_CONTEXT = 5,    /* a buffer, queue or device that belongs to another OpenCL context */
  QUELL_BUILD_FAILED = 6,   /* the device's compiler refused a kernel; the error's `got` has the build log */
  QUELL_DEVICE_ERROR = 7,   /* an OpenCL call failed; the error's `got` names the OpenCL error */
  QUELL_OUT_OF_MEMORY = 8,  /* host or device memory ran out */
  QUELL_NO_DEVICE = 9,      /* no OpenCL platform, or no platform with a usable device */
  QUELL_FILE_ERROR = 10,    /* a file is missing, unreadable, malformed or could not be written */
  QUELL_INTERNAL_ERROR = 11 /* a defect of Quell; please report it with the message */
};

/* Where the latest failure on this thread happened and how reality differed from what was expected. Texts are never
 * NULL and live until the next failure on this thread. */
typedef struct quell_error {
  size_t structSize;    /* set by QUELL_INIT */
  quell_status status;  /* what the function returned */
  const char* message;  /* one sentence made of all the others */
  const char* stage;    /* the stage or function that refused */
  const char* buffer;   /* the image, setting or argument concerned; may be empty */
  const char* expected; /* with unit */
  const char* got;      /* what came instead */
} quell_error;

/* The library's version, for example "0.1.0". */
const char* quellVersion(void);
/* The name of a status, for example "InvalidArgument"; "Success" for QUELL_SUCCESS. */
const char* quellStatusName(quell_status status);
/* The sentence of the latest failure on this thread; empty if there was none. Calls that succeed leave it. */
const char* quellErrorMessage(void);
/* The same with all its parts. */
quell_status quellGetLastError(quell_error* error);

/* --- Devices ---------------------------------------------------------------------------------------------------- */

#define QUELL_TEXT_LENGTH 256 /* of texts in structs, final zero included; longer ones are cut off */

/* A device as its runtime describes it. */
typedef struct quell_device_info {
  size_t structSize;                     /* set by QUELL_INIT */
  cl_platform_id platform;               /* whose device it is */
  cl_device_id device;                   /* needs no release */
  int index;                             /* over all platforms, in the order of enumeration */
  char platformName[QUELL_TEXT_LENGTH];  /* CL_PLATFORM_NAME */
  char name[QUELL_TEXT_LENGTH];          /* CL_DEVICE_NAME */
  char vendor[QUELL_TEXT_LENGTH];        /* CL_DEVICE_VENDOR */
  char version[QUELL_TEXT_LENGTH];       /* OpenCL version text of the device */
  char driverVersion[QUELL_TEXT_LENGTH]; /* CL_DRIVER_VERSION */
  char type[QUELL_TEXT_LENGTH];          /* "GPU", "CPU", "accelerator" or "other" */
  unsigned computeUnits;                 /* of a CPU its threads */
  size_t localMemoryBytes;               /* per work-group */
  size_t globalMemoryBytes;              /* all there is, not what is free */
  size_t maxWorkGroup;                   /* work-items */
  int images;                            /* 1: has OpenCL images; 0: images must be buffers */
  int halfArithmetic; /* 1: cl_khr_fp16; Quell needs only half storage, which every device has */
  int profiling;      /* 1: event profiling; times can still turn out to be 0 on some runtimes */
} quell_device_info;

/* How many devices all platforms have. QUELL_NO_DEVICE if there are none, with a message that says what to install. */
quell_status quellCountDevices(size_t* count);
/* Device `index`, from 0 to the count - 1; beyond it QUELL_INVALID_ARGUMENT. */
quell_status quellGetDevice(size_t index, quell_device_info* info);
/* `spec`: NULL or empty (a GPU if there is one, else an accelerator, else a CPU), an index, or part of a device or
 * platform name. QUELL_NO_DEVICE if none fits. */
quell_status quellChooseDevice(const char* spec, quell_device_info* info);

/* --- Methods and settings --------------------------------------------------------------------------------------- */

/* A method; see quellGetMethod. */
typedef struct quell_method_info {
  size_t structSize;   /* set by QUELL_INIT */
  const char* name;    /* texts live as long as the program */
  const char* summary; /* one line on what it does */
  size_t settingCount; /* for quellGetSettingInfo */
} quell_method_info;

/* Which values a setting takes. */
typedef int32_t quell_setting_kind;
enum {
  QUELL_SETTING_REAL = 0,    /* numbers from `minimum` to `maximum` */
  QUELL_SETTING_INTEGER = 1, /* whole numbers from `minimum` to `maximum` */
  QUELL_SETTING_BOOLEAN = 2, /* 0 or 1, off or on */
  QUELL_SETTING_CHOICE = 3,  /* a name of quellGetSettingChoice, or its index */
  QUELL_SETTING_TEXT = 4     /* in a form that `description` explains; has no number */
};

/* What a setting means and which values it takes. */
typedef struct quell_setting_info {
  size_t structSize;       /* set by QUELL_INIT */
  const char* name;        /* texts live as long as the program */
  quell_setting_kind kind; /* which values it takes */
  double defaultValue;     /* of a choice: its index; of a boolean: 0 or 1 */
  double minimum;          /* smallest accepted value */
  double maximum;          /* largest accepted value */
  const char* unit;        /* empty: a plain number */
  const char* description; /* what it does, in half a sentence */
  const char* source;      /* paper and section, or how the default was found */
  const char* defaultText; /* for QUELL_SETTING_TEXT only, else empty */
  size_t choiceCount;      /* for QUELL_SETTING_CHOICE only, else 0 */
  int hasPaperValue;       /* 1 if the method's paper has a value of its own */
  double paperValue;       /* that value; of no meaning without */
} quell_setting_info;

/* How many methods there are. */
quell_status quellCountMethods(size_t* count);
/* Method `index`, from 0, the default one, to the count - 1. */
quell_status quellGetMethod(size_t index, quell_method_info* info);
/* Of setting `index` of a method, from 0 to settingCount - 1. */
quell_status quellGetSettingInfo(const char* method, size_t index, quell_setting_info* info);
/* The name of one choice of setting `index`, from 0 to choiceCount - 1. */
quell_status quellGetSettingChoice(const char* method, size_t index, size_t choice, const char** name);

/* A method and the values of its settings. */
typedef struct quell_settings quell_settings;

/* The defaults of a method; NULL: of the default method. */
quell_status quellCreateSettings(const char* method, quell_settings** settings);
/* NULL is allowed. Denoisers have copies of their own. */
void quellDestroySettings(quell_settings* settings);
/* Takes numbers, on/off/true/false for booleans, the names of choices, and texts. QUELL_UNKNOWN_SETTING or
 * QUELL_OUT_OF_RANGE leave the old value. */
quell_status quellSetSetting(quell_settings* settings, const char* name, const char* value);
/* The same with a number; of a choice its index, of a boolean 0 or 1. QUELL_OUT_OF_RANGE for texts, too. */
quell_status quellSetSettingNumber(quell_settings* settings, const char* name, double value);
/* "default", or "paper" for what the method's paper says where the default is something else. */
quell_status quellUsePreset(quell_settings* settings, const char* preset);
/* The value as quellSetSetting takes it; the text lives until the next call for the same object. */
quell_status quellGetSetting(quell_settings* settings, const char* name, const char** value);
/* The value as a number; of a text 0. */
quell_status quellGetSettingNumber(const quell_settings* settings, const char* name, double* value);
/* Whether a method reads an image, with given settings. */
typedef int32_t quell_input_use;
enum {
  QUELL_UNUSED = 0,   /* does not */
  QUELL_OPTIONAL = 1, /* does where it is there */
  QUELL_REQUIRED =
      2 /* quellPrepare refuses frames without it, and without what `without` names in its place */
};

/* What a method does with one image of quell_frame. */
typedef struct quell_input_need {
  size_t structSize;   /* set by QUELL_INIT */
  const char* image;   /* member of quell_frame */
  quell_input_use use; /* with the settings that were asked about */
  const char* without; /* what counts without it */
} quell_input_need;

/* Which images a method reads with these settings: how many there are to ask about; needs no device. */
quell_status quellCountInputNeeds(quell_settings* settings, size_t* count);
/* One of them, in the order of frame_images.h; needs quellCountInputNeeds first, until whose next call for the same settings
 * texts live. QUELL_INVALID_ARGUMENT behind the last. */
quell_status quellGetInputNeed(const quell_settings* settings, size_t index, quell_input_need* need);
/* The text lives as long as the settings. */
quell_status quellGetSettingsMethod(const quell_settings* settings, const char** method);

/* --- Images and cameras ----------------------------------------------------------------------------------------- */

/* What the components of an image are in memory. */
typedef int32_t quell_component_format;
enum {
  QUELL_FLOAT32 = 0, /* IEEE single */
  QUELL_FLOAT16 = 1, /* IEEE half */
  QUELL_UINT32 = 2,  /* 32-bit unsigned integers, for object ids only */
  QUELL_IMAGE_OBJECT =
      3 /* `memory` is an OpenCL image of two dimensions, of floats, halves or normalised integers, for
         object ids also of integers */
};

/* What a pixel of an input holds where a renderer adds up samples. */
typedef int32_t quell_sum;
enum {
  QUELL_NO_SUM = 0,           /* its value */
  QUELL_COUNT_IN_FOURTH = 1,  /* the sum of the values, and their number in the fourth component */
  QUELL_OVER_SAMPLE_COUNT = 2 /* the sum of quell_frame.sampleCount values */
};

/* One image that the caller owns, in a buffer or as an OpenCL image object, row-major, pixel (0, 0) top left; float3,
 * float4, planes and interleaved structs are all described by the strides, which of image objects are 0 (see
 * quell/image_view.hpp). This struct does not grow. */
typedef struct quell_image_view {
  cl_mem memory;                 /* of the denoiser's context; not retained */
  quell_component_format format; /* QUELL_IMAGE_OBJECT: the image knows its own */
  int channels;                  /* components used per pixel, 1 to 4; 0: absent */
  size_t offsetBytes;            /* of pixel (0, 0); a multiple of the component size */
  size_t pixelStrideBytes;       /* from one pixel to the next; 0: packed */
  ptrdiff_t
      rowPitchBytes; /* from one row to the next below it; 0: width times the pixel stride; negative: bottom-up */
  quell_sum sum;     /* inputs only */
} quell_image_view;

/* This frame's camera and that of the frame before. 4x4 matrices from world to clip space, row-major, for column
 * vectors, unjittered; NDC x right, y up, in [-1, 1]; clip.w grows in front of the camera, clip.z is not used. The
 * previous one may be anything on the first frame after a reset; all zero: that of the frame before, which the denoiser
 * remembers. Jitter of this frame: sample position minus pixel centre, pixels, x right, y down, in [-1, 1]. This struct
 * does not grow. */
typedef struct quell_camera {
  double worldToClip[16];     /* of this frame */
  double worldToClipPrev[16]; /* of the frame before; all zero: the one that the denoiser remembers */
  double jitterPx[2];         /* of this frame's rays, pixels */
} quell_camera;

/* How a matrix lies in memory. */
typedef int32_t quell_matrix_order;
enum {
  QUELL_ROWS = 0, /* row by row, for column vectors: as quell_camera; also column by column for row vectors */
  QUELL_COLUMNS =
      1 /* column by column, for column vectors (GLM); also row by row for row vectors (DirectXMath) */
};

/* Both of these leave the previous matrix and the jitter as they are; QUELL_INVALID_ARGUMENT for numbers that make no
 * camera. Who has matrices in double precision writes `worldToClip` itself.
 *
 * Sets `worldToClip` to the product of two matrices of 16 floats; `worldToView` NULL: viewToClip is the product already. */
quell_status quellSetMatrices(quell_camera* camera, const float* viewToClip, const float* worldToView,
                              quell_matrix_order order);
/* Sets `worldToClip` to that of a pinhole camera. `up` points up in the picture; the field of view is in (0, 180) degrees;
 * aspect: width by height. */
quell_status quellSetLookAt(quell_camera* camera, const double eye[3], const double target[3],
                            const double up[3], double verticalFovDegrees, double aspect);

/* What the numbers of quell_frame.viewDepth mean. */
typedef int32_t quell_depth_kind;
enum {
  QUELL_DEPTH_VIEW = 0,          /* along the view axis, scene units, positive in front */
  QUELL_DEPTH_NEGATIVE_VIEW = 1, /* the same with the sign of a view space whose axis points back */
  QUELL_DEPTH_RAY = 2,           /* distance from the camera along the pixel's ray */
  QUELL_DEPTH_HYPERBOLIC = 3,    /* depth buffer: 0 at the near plane, 1 at the far one */
  QUELL_DEPTH_REVERSED =
      4 /* depth buffer: 1 at the near plane, 0 at the far one, which may be infinitely far */
};

/* A member an image. */
#define QUELL_VIEW(name, NAME, least, most, kind, presence, files, texts) quell_image_view name;
/* Inputs of one frame, read until the event of quellDenoise has completed. quellPrepare fixes `width` and `height` (1 to
 * 32768, 2^27 pixels together), which images there are, their format, channels, sum, pixel stride and row pitch,
 * `demodulated` and `depthKind`; `memory`, `offsetBytes` and all else may change from frame to frame. With a render size the
 * row pitch may, too; 0 is that of rows of `width` pixels, whatever is rendered.
 *
 * Each image of frame_images.h is a member of that name, a quell_image_view; what they hold (units, ranges, NaN) is said
 * there, in short in README.md, "Buffer contract". Of positionWorld and viewDepth one is required, never both. */
typedef struct quell_frame {
  size_t structSize;          /* set by QUELL_INIT */
  int width;                  /* pixels across, as prepared */
  int height;                 /* pixels down */
  quell_camera camera;        /* of this frame and the one before */
  int demodulated;            /* 1: light is divided by albedo and gloss colour already */
  quell_depth_kind depthKind; /* of `viewDepth`; of no meaning where that is absent */
  double depthNear;           /* of depth buffers: view depth of the near plane, scene units, > 0 */
  double depthFar;            /* and of the far one; 0: infinitely far, of QUELL_DEPTH_REVERSED only */
  double
      motionScale[2]; /* motion times this is in pixels, x right, y down, previous minus current; both 0: 1 */
  double sampleCount; /* of images with QUELL_OVER_SAMPLE_COUNT; 0: 1 */
  QUELL_FRAME_IMAGES(QUELL_VIEW)
  int renderWidth; /* dynamic resolution: pixels that this frame renders, up to `width` and `height`; both 0: all of them */
  int renderHeight; /* quellPrepare must have had such a size, too; images are read and written from pixel (0, 0) on */
} quell_frame;

/* Outputs of one frame: linear and display (frame_images.h), either or both. */
typedef struct quell_output {
  size_t structSize; /* set by QUELL_INIT */
  QUELL_OUTPUT_IMAGES(QUELL_VIEW)
} quell_output;
#undef QUELL_VIEW

#ifndef QUELL_DECLARATIONS_ONLY
/* A packed image at the start of a buffer; `memory` may be NULL for quellPrepare. */
static inline quell_image_view quellPackedImage(cl_mem memory, int channels, quell_component_format format) {
  quell_image_view view;
  memset(&view, 0, sizeof(view));
  view.memory = memory;
  view.format = format;
  view.channels = channels;
  return view;
}

/* An OpenCL image object, of which `channels` components count. */
static inline quell_image_view quellImageObject(cl_mem memory, int channels) {
  return quellPackedImage(memory, channels, QUELL_IMAGE_OBJECT);
}

/* The same memory with its rows bottom-up, as OpenGL has them; the view says where the memory's first row is. */
static inline quell_image_view quellBottomUp(quell_image_view view, int width, int height) {
  const size_t component = view.format == QUELL_FLOAT16 ? 2 : 4;
  const size_t stride =
      view.pixelStrideBytes != 0 ? view.pixelStrideBytes : component * (size_t)view.channels;
  const ptrdiff_t pitch = view.rowPitchBytes != 0 ? view.rowPitchBytes : (ptrdiff_t)(stride * (size_t)width);
  if (view.format == QUELL_IMAGE_OBJECT) {
    view.rowPitchBytes = -1;
  } else {
    view.offsetBytes += (size_t)(height - 1) * (size_t)pitch;
    view.rowPitchBytes = -pitch;
  }
  return view;
}

/* A view whose pixels are sums. */
static inline quell_image_view quellSummed(quell_image_view view, quell_sum sum) {
  view.sum = sum;
  return view;
}
#endif

/* --- Denoiser --------------------------------------------------------------------------------------------------- */

/* Whether and how frames are timed. */
typedef int32_t quell_timer_mode;
enum {
  QUELL_TIMERS_OFF = 0, /* not at all */
  QUELL_TIMERS_DEVICE =
      1, /* needs CL_QUEUE_PROFILING_ENABLE, else the queue is refused; as host where a driver's events carry no times */
  QUELL_TIMERS_HOST = 2 /* completion callbacks */
};

/* How per-pixel work is spread over work-items; results differ by rounding at most. */
typedef int32_t quell_mapping;
enum {
  QUELL_MAPPING_AUTOMATIC = 0, /* wide on CPU devices, narrow elsewhere */
  QUELL_MAPPING_NARROW = 1,    /* one pixel a work-item */
  QUELL_MAPPING_WIDE = 2,      /* as many pixels of a row a work-item as fill the device's native vector */
  QUELL_MAPPING_WIDE_4 = 3,    /* four of them, whatever the device */
  QUELL_MAPPING_WIDE_8 = 4,    /* eight of them */
  QUELL_MAPPING_WIDE_16 = 5    /* sixteen of them */
};

/* What a denoiser is made with, for good. All zero suits a renderer: kernels lie in $XDG_CACHE_HOME/quell, else in
 * ~/.cache/quell, for the next process. Those of PoCL lie there only where a directory is named: it has a cache of its own, and
 * compiles twice to give binaries away. */
typedef struct quell_options {
  size_t structSize;          /* set by QUELL_INIT */
  quell_timer_mode timers;    /* for quellGetTimings; costs an event a kernel */
  quell_mapping mapping;      /* 0: what suits the device */
  int workGroup[2];           /* of per-pixel kernels, work-items in x and y; 0: chosen */
  int fitGroup;               /* work-items per block of the fit, a power of two up to 256; 0: chosen */
  const char* cacheDirectory; /* of compiled kernels; "": none; NULL: the user's */
  const char* keptBuffers;    /* intermediate buffers for quellReadBuffer, separated by commas; may be NULL */
  const char*
      captureDirectory; /* folder for bug reports, a new one in it each quellPrepare; NULL: $QUELL_CAPTURE, "": none */
  int captureFrames; /* how many frames are written there after each quellPrepare; 0: 8 */
  int captureSkip;   /* how many are left out before */
} quell_options;

/* Denoises a sequence of frames, each after the one before, on one queue at a time. */
typedef struct quell_denoiser quell_denoiser;

/* The OpenCL handles are retained as long as needed. `settings` NULL: the default method with its defaults;
 * `options` NULL: defaults. Both are copied. */
quell_status quellCreateDenoiser(cl_context context, cl_device_id device, cl_command_queue queue,
                                 const quell_settings* settings, const quell_options* options,
                                 quell_denoiser** denoiser);
/* Safe while frames are pending: they run to their end. Waits for the kernel that quellPrepareAsync is compiling. NULL is
 * allowed. */
void quellDestroyDenoiser(quell_denoiser* denoiser);

/* Builds all kernels for these layouts, allocates all memory and warms up; blocks. Memory may be NULL here;
 * what is given is checked. May be called again for other sizes or layouts; the history and the times are reset. Waits for
 * pending frames, so what these wait for must not depend on this thread. Arguments that it refuses, such as the 0x0 of a
 * minimised window, change nothing; after a failure to build nothing is prepared any more. */
quell_status quellPrepare(quell_denoiser* denoiser, const quell_frame* frame, const quell_output* output);

/* How far a preparation is: what has been built or launched last, and steps. Called on the thread that prepares; may call
 * quellCancelPrepare and nothing else of that denoiser. */
typedef void (*quell_prepare_callback)(const char* stage, int done, int total, void* user);

/* How to prepare; all zero: as quellPrepare does. */
typedef struct quell_prepare_options {
  size_t structSize;               /* set by QUELL_INIT */
  int keepHistory;                 /* 1: what can be kept is, resampled after a change of size */
  const quell_settings* settings;  /* of the same method, instead of those before; may be NULL */
  quell_prepare_callback progress; /* may be NULL */
  void* user;                      /* for `progress` */
} quell_prepare_options;

/* quellPrepare with options, which may be NULL. */
quell_status quellPrepareWith(quell_denoiser* denoiser, const quell_frame* frame, const quell_output* output,
                              const quell_prepare_options* options);
/* The same on a thread of the denoiser's own; returns at once: until quellIsReady says 1, quellDenoise returns
 * QUELL_NOT_PREPARED. What building failed with is returned by the next quellIsReady or quellDenoise, once. */
quell_status quellPrepareAsync(quell_denoiser* denoiser, const quell_frame* frame, const quell_output* output,
                               const quell_prepare_options* options);
/* Writes 1 where quellDenoise may be called, else 0; does not block. Fails once with what quellPrepareAsync failed with. */
quell_status quellIsReady(quell_denoiser* denoiser, int* ready);
/* Ends a preparation after the program that is being compiled, from any thread: it fails with QUELL_NOT_PREPARED. */
quell_status quellCancelPrepare(quell_denoiser* denoiser);

/* Where the machine code of a stage would come from. */
typedef int32_t quell_kernel_state;
enum {
  QUELL_KERNEL_MISSING =
      0, /* is compiled (a runtime may have it in a cache of its own, which cannot be asked) */
  QUELL_KERNEL_CACHED = 1, /* on disk, or in this process */
  QUELL_KERNEL_BUILT = 2   /* by this denoiser */
};
/* The kernels of one stage. */
typedef struct quell_stage_kernel {
  size_t structSize;        /* set by QUELL_INIT */
  const char* stage;        /* lives until the next quellCountStageKernels of this denoiser */
  quell_kernel_state state; /* of that kernel of the stage which is furthest from being built */
} quell_stage_kernel;
/* What quellPrepare would have to compile for these layouts: how many stages there are. Compiles nothing. */
quell_status quellCountStageKernels(quell_denoiser* denoiser, const quell_frame* frame,
                                    const quell_output* output, size_t* count);
/* One of these stages, as it was then; needs quellCountStageKernels first. QUELL_INVALID_ARGUMENT behind the last. */
quell_status quellGetStageKernel(const quell_denoiser* denoiser, size_t index, quell_stage_kernel* kernel);

/* Takes other values from the next frame on; the history stays, nothing blocks. QUELL_NOT_PREPARED, naming the settings
 * that need quellPrepareWith, changes nothing. */
quell_status quellSetSettings(quell_denoiser* denoiser, const quell_settings* settings);

/* quellDenoise on another queue of the same context and device for this frame, which comes after the frame before by an
 * event. */
quell_status quellDenoiseOn(quell_denoiser* denoiser, cl_command_queue queue, const quell_frame* frame,
                            const quell_output* output, cl_uint waitCount, const cl_event* waitList,
                            cl_event* done);

/* Enqueues one frame; never builds, allocates device memory, copies through the host or blocks. Work starts when all
 * of the wait list's events have completed (on an in-order queue also after all earlier commands). `done` receives an
 * event that the caller releases; NULL if not wanted. waitCount 0: waitList may be NULL. The queue is flushed.
 *
 * Any number of frames may be pending: they run one after the other on every kind of queue, so that inputs and outputs
 * alone need a copy per frame in flight, until `done` of theirs.
 *
 * What is refused is refused before anything is enqueued, and nothing is written to `done`: QUELL_NOT_PREPARED for another
 * size or layout, QUELL_WRONG_CONTEXT, QUELL_INVALID_ARGUMENT or QUELL_OUT_OF_RANGE for unusable buffers, events or
 * cameras, QUELL_DEVICE_ERROR for an event of the wait list that has failed. A frame that fails later gives `done` a
 * negative status and restarts the history; go on with the next one. */
quell_status quellDenoise(quell_denoiser* denoiser, const quell_frame* frame, const quell_output* output,
                          cl_uint waitCount, const cl_event* waitList, cl_event* done);

/* Forgets all earlier frames, as a cut needs it. Does not block. */
quell_status quellResetHistory(quell_denoiser* denoiser);

/* --- Debugging -------------------------------------------------------------------------------------------------- */

/* How bad a finding is. */
typedef int32_t quell_severity;
enum {
  QUELL_NOTE = 0,     /* worth knowing; the frame is as the contract says */
  QUELL_DOUBTFUL = 1, /* may be meant, and costs quality where it isn't */
  QUELL_WRONG = 2     /* against the contract (frame_images.h) */
};

/* "note", "doubtful" or "wrong"; "unknown" for other numbers. */
const char* quellSeverityName(quell_severity severity);

/* What quellCheckFrame has found. */
typedef struct quell_frame_check {
  size_t structSize;    /* set by QUELL_INIT */
  quell_severity worst; /* of the findings; QUELL_NOTE if there are none */
  size_t findingCount;  /* for quellGetFinding */
  size_t figureCount;   /* for quellGetCheckFigure */
} quell_frame_check;

/* One thing that is odd about a frame. Texts live until the next quellCheckFrame of this denoiser. */
typedef struct quell_finding {
  size_t structSize;       /* set by QUELL_INIT */
  quell_severity severity; /* how bad it is */
  const char* kind;        /* for example "camera-transposed"; stable across releases */
  const char* image;       /* member of quell_frame that it is about */
  const char* expected;    /* what the contract says */
  const char* got;         /* what was measured, with units */
  const char* cure;        /* what most likely sets it right */
  const char* sentence;    /* made of all the others */
  size_t pixels;           /* how many show it; 0 where it is about the frame as a whole */
} quell_finding;

/* Something measured, whether or not it is odd. Texts live as those of findings. */
typedef struct quell_check_figure {
  size_t structSize; /* set by QUELL_INIT */
  const char* name;  /* for example "surface share" */
  const char* unit;  /* for example "%"; empty: a plain number */
  double value;      /* in `unit` */
} quell_check_figure;

/* Says what is odd about a frame that quellDenoise would take, and what would cure it: transposed matrices, packed
 * normals, depth of another kind, light that was summed up, and more. Reads all images to the host and blocks, once the
 * events of the wait list have completed; needs no quellPrepare. The frame checked last is kept in host memory and
 * compared with, so check frames in a row; quellResetHistory forgets it. `check` may be NULL. quellGetFinding then gives
 * the findings, from 0 to findingCount - 1, causes before what follows from them, and quellGetCheckFigure the figures. */
quell_status quellCheckFrame(quell_denoiser* denoiser, const quell_frame* frame, cl_uint waitCount,
                             const cl_event* waitList, quell_frame_check* check);
/* Finding `index` of the latest quellCheckFrame; QUELL_INVALID_ARGUMENT behind the last. */
quell_status quellGetFinding(const quell_denoiser* denoiser, size_t index, quell_finding* finding);
/* Figure `index` of the latest quellCheckFrame; QUELL_INVALID_ARGUMENT behind the last. */
quell_status quellGetCheckFigure(const quell_denoiser* denoiser, size_t index, quell_check_figure* figure);

/* The method's intermediate buffers, in the order in which a frame touches them; none before quellPrepare. Names live
 * until the next quellCountBuffers of this denoiser, which quellGetBufferName needs first. */
quell_status quellCountBuffers(quell_denoiser* denoiser, size_t* count);
/* The name of buffer `index`, from 0 to the count - 1. */
quell_status quellGetBufferName(const quell_denoiser* denoiser, size_t index, const char** name);

/* An intermediate buffer, for debugging. */
typedef struct quell_buffer_content {
  size_t structSize; /* set by QUELL_INIT */
  int width;         /* pixels; of buffers that are not images the number of elements */
  int height;        /* pixels; of buffers that are not images 1 */
  int planes;        /* of buffers that are not images 1 */
} quell_buffer_content;

/* One of the method's intermediate buffers as the latest frame has left it; blocks until that frame is done. `values`
 * receives width * height * planes numbers, plane by plane, row by row; NULL with capacity 0 to learn the size alone.
 * QUELL_INVALID_ARGUMENT for a smaller capacity, for a name that the method does not have (the message lists those that
 * it has) and for one that is neither among quell_options.keptBuffers nor a history; QUELL_NOT_PREPARED before the first
 * frame after quellPrepare or quellResetHistory. */
quell_status quellReadBuffer(const quell_denoiser* denoiser, const char* name, float* values, size_t capacity,
                             quell_buffer_content* content);

/* What has become of quell_options.captureDirectory. */
typedef struct quell_capture_state {
  size_t structSize;     /* set by QUELL_INIT */
  const char* directory; /* the folder of the latest quellPrepare; empty: nothing is captured */
  const char* problem;   /* a sentence on what ended the capture early; empty: nothing did */
  int frames;            /* that are written; the others may still be pending */
} quell_capture_state;
/* What was written of quell_options.captureDirectory so far; texts live until the next call for this denoiser. */
quell_status quellGetCaptureState(quell_denoiser* denoiser, quell_capture_state* state);

/* What running a capture again has shown. */
typedef struct quell_replay {
  size_t structSize;   /* set by QUELL_INIT */
  int equal;           /* 1: all outputs, bit for bit */
  int frameCount;      /* of all folders */
  int differenceCount; /* facts, such as device and driver, that were not the same where they were captured */
  const char* text;    /* on all of it; lives until the next quellReplay on this thread */
} quell_replay;
/* Runs a captured folder, or all of them that lie in a folder, once more; blocks. `cacheDirectory` as in quell_options.
 * QUELL_FILE_ERROR for folders that are no captures or are damaged. */
quell_status quellReplay(const char* directory, cl_context context, cl_device_id device,
                         cl_command_queue queue, const char* cacheDirectory, quell_replay* replay);

/* What the latest frame left out because it is background (setting `skip`). All zero before the first frame after
 * quellPrepare or quellResetHistory, and for methods and settings that leave out nothing. */
typedef struct quell_background_map {
  size_t structSize; /* set by QUELL_INIT */
  int itemWidth;     /* pixels of a row that one work-item takes: 1, 4, 8 or 16 */
  int columns;       /* work-items across */
  int rows;          /* work-items down, one a row of pixels */
  double share;      /* of the work-items that are left out, 0 to 1 */
  size_t stageCount; /* stages that leave them out */
} quell_background_map;

/* Blocks until the latest frame is done. `background` receives columns * rows bytes, row by row, 1: all pixels of the
 * work-item are background; NULL with capacity 0 to learn the size alone. QUELL_INVALID_ARGUMENT for a smaller
 * capacity. quellGetBackgroundStage then gives the labels of the stages, from 0 to stageCount - 1; they live until the
 * next quellGetBackgroundMap of this denoiser. */
quell_status quellGetBackgroundMap(quell_denoiser* denoiser, unsigned char* background, size_t capacity,
                                   quell_background_map* map);
/* The label of stage `index`; see quellGetBackgroundMap. */
quell_status quellGetBackgroundStage(const quell_denoiser* denoiser, size_t index, const char** label);

/* A copy of the settings of the denoiser; the caller destroys it. */
quell_status quellGetDenoiserSettings(const quell_denoiser* denoiser, quell_settings** settings);

/* --- Memory and times ------------------------------------------------------------------------------------------- */

/* Device memory of a denoiser. */
typedef struct quell_memory_use {
  size_t structSize;  /* set by QUELL_INIT */
  size_t totalBytes;  /* device memory held since quellPrepare; the caller's images not included */
  size_t bufferCount; /* for quellGetBufferUse */
} quell_memory_use;

/* Memory of one buffer, or of several by turns, which are named together. */
typedef struct quell_buffer_use {
  size_t structSize; /* set by QUELL_INIT */
  const char* name;  /* lives until the next quellGetMemoryUse or quellGetMemoryNeeded of this denoiser */
  size_t bytes;      /* on the device */
} quell_buffer_use;

/* Where times come from. */
typedef int32_t quell_time_source;
enum {
  QUELL_TIME_DEVICE = 0, /* OpenCL event profiling */
  QUELL_TIME_HOST = 1    /* completion callbacks; includes scheduling delays */
};

/* Over the frames since timers were last cleared or quellPrepare ran, at most the latest 4096, milliseconds; all zero if there
 * are none. This struct does not grow. */
typedef struct quell_time_statistics {
  size_t count;    /* frames counted, at most 4096 */
  double medianMs; /* of an even number of frames the mean of the two in the middle */
  double meanMs;   /* single slow frames count; prefer the median */
  double minMs;    /* the fastest frame */
  double maxMs;    /* the slowest frame */
} quell_time_statistics;

/* Times of a denoiser's frames. */
typedef struct quell_timings {
  size_t structSize;           /* set by QUELL_INIT */
  quell_time_source source;    /* which of the two the times are of */
  size_t stageCount;           /* 0 if timers are off */
  quell_time_statistics frame; /* start of the first kernel to end of the last, gaps included */
} quell_timings;

/* Times of one line of a method's table. What runs on other queues meanwhile is in them: on a CPU a stage may seem many times
 * as long, and minMs is closer to what it takes. What is left out is known while no frame is pending;
 * until then bytesMoved is that of a frame without background. */
typedef struct quell_stage_timings {
  size_t structSize;          /* set by QUELL_INIT */
  const char* stage;          /* lives until the next quellGetTimings of this denoiser */
  quell_time_statistics time; /* sum over the stage's kernels */
  uint64_t lastQueuedNs;      /* event times of the latest finished frame, device clock; 0 with host times */
  uint64_t lastSubmitNs;      /* of the stage's first kernel */
  uint64_t lastStartNs;       /* of the stage's first kernel */
  uint64_t lastEndNs;         /* of its last kernel */
  uint64_t
      bytesMoved; /* that the stage must read and write per frame, each counted once, less what is left out */
  const char* label;   /* the stage's name, with what tells it from others of that name; lives as `stage` */
  int hasSkippedShare; /* 0 where it is not known, or nothing can be left out */
  double skippedShare; /* work left out over all work, 0 to 1 */
} quell_stage_timings;

/* What quellPrepare would allocate for these layouts; quellGetBufferUse then gives the parts. Allocates and builds
 * nothing. Its names replace those of quellGetMemoryUse. */
quell_status quellGetMemoryNeeded(quell_denoiser* denoiser, const quell_frame* frame,
                                  const quell_output* output, quell_memory_use* use);
/* Takes stock; quellGetBufferUse then gives the parts, from 0 to bufferCount - 1. */
quell_status quellGetMemoryUse(quell_denoiser* denoiser, quell_memory_use* use);
/* Part `index` of what the latest of the two calls above has counted. */
quell_status quellGetBufferUse(const quell_denoiser* denoiser, size_t index, quell_buffer_use* use);

/* Collects the times of all frames that have finished so far, never waiting for more; quellGetStageTimings then gives
 * the stages, from 0 to stageCount - 1. */
quell_status quellGetTimings(quell_denoiser* denoiser, quell_timings* timings);
/* Stage `index` of the latest quellGetTimings. */
quell_status quellGetStageTimings(const quell_denoiser* denoiser, size_t index, quell_stage_timings* timings);
/* Starts the statistics afresh; frames that are pending still count. */
quell_status quellClearTimings(quell_denoiser* denoiser);

QUELL_C_API_END

#endif
