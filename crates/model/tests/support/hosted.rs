//! A module in a host as on a web page, with our own functions in place of the browser's.

use machinist_contract::Real;
use machinist_model::Function;
use machinist_model::evaluate::call;
use machinist_model::wasm::{HOST, POWER, WasmModule};
use wasmi::{Engine, Instance, Linker, Memory, Module, Store};

pub struct Hosted {
    store: Store<()>,
    instance: Instance,
    memory: Memory,
    module: WasmModule,
}

impl Hosted {
    pub fn new(module: WasmModule) -> Self {
        let engine = Engine::default();
        let code = Module::new(&engine, &module.bytes[..]).expect("a module");
        let (mut store, mut linker) = (Store::new(&engine, ()), Linker::new(&engine));
        for (function, name) in Function::ALL {
            let of_one = move |x: f64| call(function, x);
            linker.func_wrap(HOST, name, of_one).expect("told once");
        }
        linker.func_wrap(HOST, POWER, |x: f64, y: f64| Real::powf(x, y)).expect("told once");
        let instance = linker.instantiate_and_start(&mut store, &code).expect("an instance");
        let memory = instance.get_memory(&store, "memory").expect("a memory");
        Self { store, instance, memory, module }
    }

    /// Sets the parameters of later runs.
    pub fn set(&mut self, parameters: &[f64]) {
        self.write(self.module.layout.parameters, parameters);
        self.run("prepare", 0.0);
    }

    /// Returns `count` results of a function at a time and a state.
    pub fn results(&mut self, name: &str, time: f64, state: &[f64], count: usize) -> Vec<f64> {
        self.write(self.module.layout.state, state);
        self.run(name, time);
        let mut bytes = vec![0; 8 * count];
        self.memory.read(&self.store, self.module.layout.results, &mut bytes).expect("within");
        let (numbers, _) = bytes.as_chunks();
        numbers.iter().map(|number| f64::from_le_bytes(*number)).collect()
    }

    fn write(&mut self, place: usize, numbers: &[f64]) {
        let bytes: Vec<u8> = numbers.iter().flat_map(|number| number.to_le_bytes()).collect();
        self.memory.write(&mut self.store, place, &bytes).expect("within");
    }

    fn run(&mut self, name: &str, time: f64) {
        let function = self.instance.get_typed_func::<f64, ()>(&self.store, name);
        function.expect("exported").call(&mut self.store, time).expect("it runs");
    }
}
